// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace pellucid {

/// While a DefaultFloats lives, its thread rounds to nearest and keeps denormal numbers, whatever a
/// library that calls back has set; then it is as before.
class DefaultFloats {
 public:
#if defined(__SSE__)
  DefaultFloats() : before_(_mm_getcsr()) { _mm_setcsr(0x1F80); }  // all exceptions masked
  ~DefaultFloats() { _mm_setcsr(before_); }
#else
  DefaultFloats() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloats() { std::fesetenv(&before_); }
#endif
  DefaultFloats(const DefaultFloats&) = delete;
  DefaultFloats& operator=(const DefaultFloats&) = delete;

 private:
#if defined(__SSE__)
  unsigned before_;
#else
  std::fenv_t before_;
#endif
};

}  // namespace pellucid
