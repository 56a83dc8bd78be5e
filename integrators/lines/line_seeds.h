// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace pellucid::integrators {

/// LineSeeds are where the lines of a surface start on its seed curve, s in [0, 1]: in the limit of
/// many lines with a given density, and as evenly as it allows after any number of them.
///
/// Seeds are the multiples of the golden ratio modulo 1: of all such sequences it leaves the
/// smallest gaps (Graham and van Lint 1968, "On the distribution of nθ modulo 1", Canad. J. Math.
/// 20).
class LineSeeds {
 public:
  /// The largest gap between any number of even seeds is so many mean gaps: 1 + 2/√5.
  static constexpr double largest_gap = 1.8945;

  /// Evenly spread.
  LineSeeds();
  /// Makes seeds as dense as `importance(s)` >= 0 asks for, found by bisecting where most of it
  /// lies; a tenth of the lines is spread evenly all the same. `importance` is called from several
  /// threads.
  explicit LineSeeds(const std::function<double(double s)>& importance);

  /// The seed of line number `line` and the density of lines there, per s, of mean 1.
  struct Seed {
    double s, density;
  };
  Seed seed(std::uint64_t line) const;

 private:
  std::vector<double> s_;         // ends of intervals, ascending from 0 to 1
  std::vector<double> fraction_;  // of the lines that start before s_[i]
};

}  // namespace pellucid::integrators
