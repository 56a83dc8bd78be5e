// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/line_options.h"

namespace pellucid::integrators {
namespace {

constexpr OptionText particles_text = {
    .min = 1, .max = 1e6, .unit = "particles", .help = "lines, evenly spaced on the seed curve"};

constexpr OptionText max_vertices_text = {
    .min = 2,
    .max = 1e10,
    .unit = "vertices",
    .help = "of all lines together, shared evenly: a line ends that would have more"};

}  // namespace

const OptionTable<FollowingOptions>& following_options() {
  using Options = FollowingOptions;
  static const OptionTable<Options> table{
      number("particles", &Options::particles, particles_text),
      number("step", &Options::step,
             {.min = 0,
              .unit = "world units",
              .help = "between a line's vertices; default: by the turn"}),
      number("turn", &Options::turn,
             {.min = 0.01,
              .max = 90,
              .unit = "degrees",
              .help = "a line turns at most so far between two vertices"}),
      number("max-vertices", &Options::max_vertices, max_vertices_text),
      part(&Options::stepping, stepping_options())};
  return table;
}

const OptionTable<StreakOptions>& streak_options() {
  using Options = StreakOptions;
  static const OptionTable<Options> table{
      number("particles", &Options::particles, particles_text),
      number("releases", &Options::releases,
             {.min = 1,
              .max = 1e6,
              .unit = "particles",
              .help = "let go at each seed, evenly spaced in time"}),
      number("max-vertices", &Options::max_vertices, max_vertices_text),
      part(&Options::stepping, stepping_options())};
  return table;
}

}  // namespace pellucid::integrators
