// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "compare/cells/measure_cell.h"

namespace pellucid::compare {

/// Adds curves of the optical depth τ over d in [0, 1] along the rays of the cell's probed pixels:
/// what the method made of it, if it has such a function, and to an exact reference's row the exact
/// steps; of a Fourier series the sizes of its coefficients, too. Throws InputError for a pixel
/// outside the picture.
void add_ray_curves(const Cell& cell, const scene::Scene& scene, scene::Renderer& renderer,
                    CellMeasurement& measured);

}  // namespace pellucid::compare
