// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/calibration.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/machine/stopwatch.h"

namespace pellucid {
namespace {

// The call takes at least twice the median of its three loops: two are no shorter.
TEST(UnitCalibration, IsTheMedianOfItsLoops) {
  const Stopwatch watch;
  const Calibration calibration = calibrate();
  EXPECT_GT(calibration.seconds, 1e-4);  // half a million steps of at least three cycles
  EXPECT_LE(2 * calibration.seconds, watch.seconds());
}

TEST(UnitCalibration, SaysWhenItWas) {
  const double before = calibrate().at, after = calibrate().at;
  EXPECT_LT(before, after);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  EXPECT_NEAR(after, std::chrono::duration<double>(now).count(), 60);
}

}  // namespace
}  // namespace pellucid
