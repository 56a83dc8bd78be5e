// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace pellucid {

/// Told how far long work has come: `fraction` in [0, 1] and what is being done. Empty: nobody
/// asks. Only app/ prints. It may be called from any one thread at a time.
using Progress = std::function<void(double fraction, std::string_view what)>;

inline void report(const Progress& progress, double fraction, std::string_view what) {
  if (progress) progress(fraction, what);
}

}  // namespace pellucid
