// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace pellucid::fields {

/// A Lazy is a value that is made when it is first asked for, once, by whichever thread asks.
template <class Value>
class Lazy {
 public:
  template <class Make>
  const Value& get(const Make& make) const {
    std::call_once(made_, [&] { value_ = make(); });
    return value_;
  }

 private:
  mutable std::once_flag made_;
  mutable Value value_{};
};

}  // namespace pellucid::fields
