// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/calibration.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "core/machine/stopwatch.h"
#include "core/parallel.h"

namespace pellucid {
namespace {

/// Each step waits for the last one: the loop's time is that of the processor's clock, whatever
/// its caches hold. The numbers stay in [0, 1].
double fixed_arithmetic() {
  constexpr int steps = 500'000;
  volatile double seed = 0.3;  // so that the sum is not known before
  double x = seed;
  for (int i = 0; i < steps; ++i) x = 3.9 * x * (1 - x);
  return x;
}

double timed_loop() {
  const int threads = tbb::this_task_arena::max_concurrency();
  const Stopwatch watch;
  parallel_for(0, threads, [](int) {
    volatile double kept = fixed_arithmetic();  // so that the loop is not left out
    (void)kept;
  });
  return watch.seconds();
}

}  // namespace

Calibration calibrate() {
  std::array<double, 3> times{};
  for (double& time : times) time = timed_loop();
  std::sort(times.begin(), times.end());
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(now).count(), times[1]};
}

}  // namespace pellucid
