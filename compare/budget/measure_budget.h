// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cells/cell.h"
#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// Draws the cell's picture with its stages refined, one at a time and all but one, and adds to the
/// row the budget of its error (split_error()) and, for each stage, a picture of its part. `scene`
/// is the cell's, as it was drawn; its camera and size are kept. Where there is no budget, the
/// row's explanation says why. Throws what a method throws.
void add_budget(const Cell& cell, const MethodCall& reference, const scene::Scene& scene,
                const scene::RenderContext& context, CellMeasurement& measured);

}  // namespace pellucid::compare
