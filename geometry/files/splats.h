// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kerbl et al., 3D Gaussian Splatting for Real-Time Radiance Field Rendering, 2023: a trained scene
// is a PLY file of points whose numbers are kept before their activation functions. The Gaussians
// themselves are not drawn here: each is one ball of its peak opacity, whatever its shape.

#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {

/// Says whether points are Gaussians: they have f_dc_0 … 2, opacity and scale_0 … 2.
bool are_splats(const VertexAttributes& attributes);

/// Gives them colours: 1/2 + f_dc / (2 √π), the spherical harmonics of degree 0, clamped to [0, 1];
/// alpha 1 / (1 + exp(-opacity)); and the scalar `radius`, the geometric mean of exp(scale), world
/// units. What depends on the direction, f_rest_…, is left out.
void take_splats(VertexAttributes& attributes);

}  // namespace pellucid::geometry
