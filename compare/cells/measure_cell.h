// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cells/cell.h"
#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// Makes the renderer, renders once to warm up and to count layers, then `repeats` timed times.
/// Throws WorkError when the picture has pixels that are not finite, and what the method throws.
CellMeasurement measure_cell(const Cell& cell, const scene::Scene& scene, int repeats,
                             const scene::RenderContext& context);

/// Checks how an exact method's numbers of layers, and its picture where they agree, fit the
/// reference. All have one size.
CoverageCheck check_coverage(const Image& reference, const CountImage& reference_layers,
                             const Image& test, const CountImage& test_layers);

}  // namespace pellucid::compare
