// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/opacity_energy.h"

namespace pellucid::scene {
namespace {

constexpr double largest_weight = 1e12;  // beyond the paper's by far, and safe in float

// The help names them.
constexpr EnergyWeights weights;
static_assert(weights.q == 50 && weights.r == 100 && weights.lambda == 2 && weights.p == 1);

}  // namespace

const OptionTable<EnergyOptions>& energy_options() {
  static const OptionTable<EnergyOptions> table{
      number("q", &EnergyOptions::q,
             {.min = 0,
              .max = largest_weight,
              .help = "fades what is unimportant in front of what is important; the scene's, or "
                      "50"}),
      number("r", &EnergyOptions::r,
             {.min = 0,
              .max = largest_weight,
              .help = "fades what is unimportant behind what is important; the scene's, or 100"}),
      number("lambda", &EnergyOptions::lambda,
             {.min = 0,
              .max = 100,
              .help = "how fast a fragment ceases to be important as g falls from 1; the scene's, "
                      "or 2"}),
      number("p", &EnergyOptions::p,
             {.min = 1e-12,
              .max = largest_weight,
              .help = "keeps fragments opaque; the scene's, or 1"})};
  return table;
}

}  // namespace pellucid::scene
