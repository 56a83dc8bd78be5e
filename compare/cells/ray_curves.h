// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cells/measure_cell.h"

namespace pellucid::compare {

/// Adds curves over d in [0, 1] along the rays of the cell's probed pixels, of the optical depth
/// τ(d) and, where the scene has importance, of G(d): what the method made of them, if it has such
/// functions, and to the reference's row the exact steps, those of τ if the reference is exact. Of
/// a Fourier series the sizes of its terms are added as a curve, and as measures that of the fifth
/// and the largest one beyond: the largest of all probes. Throws InputError for a pixel outside the
/// picture.
void add_ray_curves(const Cell& cell, const scene::Scene& scene, scene::Renderer& renderer,
                    CellMeasurement& measured);

/// Says whether a measure of this name is one of those, which only the view of the probes has.
bool is_of_probes(std::string_view measure);

}  // namespace pellucid::compare
