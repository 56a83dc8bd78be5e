// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace pellucid {

/// A Stopwatch measures the wall-clock seconds since it was made or restarted.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  void restart() { start_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace pellucid
