// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid {

/// A Calibration is how long a loop of fixed arithmetic took, and when: a machine that is as fast
/// as before takes as long as before.
struct Calibration {
  double at = 0;       // when it ended, seconds since 1970
  double seconds = 0;  // wall clock
};

/// Runs a loop of the same arithmetic on each thread that loops may use here, three times, and
/// returns the median of the three times: some milliseconds, longer where another program has the
/// processors, or where their clock has sunk.
Calibration calibrate();

}  // namespace pellucid
