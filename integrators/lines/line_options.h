// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/options/option_table.h"
#include "integrators/paths/stepping_options.h"

namespace pellucid::integrators {

/// FollowingOptions are those of stream lines and path lines.
struct FollowingOptions {
  int particles = 20;          // lines, evenly spaced on the seed curve
  std::optional<double> step;  // world units between a line's vertices; not set: by the turn
  double turn = 3;             // degrees: a line turns at most so far between two vertices
  std::uint64_t max_vertices = 20'000'000;  // of all lines: no default run takes more than 2 GB
  SteppingOptions stepping;
};

/// StreakOptions are those of streak lines.
struct StreakOptions {
  int particles = 20;                       // lines, evenly spaced on the seed curve
  int releases = 200;                       // particles let go at each seed, evenly spaced in time
  std::uint64_t max_vertices = 20'000'000;  // of all lines
  SteppingOptions stepping;
};

/// Returns the table of the options.
///@{
const OptionTable<FollowingOptions>& following_options();
const OptionTable<StreakOptions>& streak_options();
///@}

}  // namespace pellucid::integrators
