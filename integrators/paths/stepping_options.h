// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/options/option_table.h"
#include "integrators/paths/butcher_tableau.h"

namespace pellucid::integrators {

/// How particles move, as a user has it. What is not set depends on the field and on the way that
/// is asked for: trajectory_options() says how.
struct SteppingOptions {
  const ButcherTableau* stepper = &dopri5();
  std::optional<double> accuracy;       // world units: largest estimated error of one step
  std::optional<double> dt;             // time units: largest step; that of euler and rk4
  std::optional<double> cells;          // largest step in sampled data, in cells
  std::optional<double> length;         // world units: a particle ends when it has gone so far
  std::uint64_t max_steps = 1'000'000;  // a particle ends after so many
};

/// Returns the table of SteppingOptions.
const OptionTable<SteppingOptions>& stepping_options();

}  // namespace pellucid::integrators
