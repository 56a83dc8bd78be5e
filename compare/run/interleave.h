// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/cells/measure_cell.h"

namespace pellucid::compare {

/// A MeasuredCell is what was measured of a cell, or why it could not be.
struct MeasuredCell {
  std::optional<CellMeasurement> measurement;
  std::string error;
};

/// Measures the cells of one scene in turn: in each round every cell that the rule has not ended is
/// timed once, each round beginning with another one, so that what disturbs the machine for a while
/// disturbs all. A cell that throws is left out from there on. Each cell has its own of `contexts`.
/// `between` is called after each round.
std::vector<MeasuredCell> measure_interleaved(std::span<const Cell> cells,
                                              const scene::Scene& scene, const TimingRule& timing,
                                              std::span<const scene::RenderContext> contexts,
                                              const std::function<void()>& between);

}  // namespace pellucid::compare
