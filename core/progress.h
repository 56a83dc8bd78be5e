// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace pellucid {

/// A Progress is told how far long work has come: `fraction` in [0, 1] and what is being done. An
/// empty one says that nobody asks. Only app/ prints. It is called from one thread at a time, any.
using Progress = std::function<void(double fraction, std::string_view what)>;

/// Tells `progress` the `fraction`, in [0, 1], and what is being done, unless it is empty.
inline void report(const Progress& progress, double fraction, std::string_view what) {
  if (progress) progress(fraction, what);
}

}  // namespace pellucid
