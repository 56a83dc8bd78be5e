// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/renderer.h"

namespace pellucid::compare {

/// Ray-traces `mesh`, opaque, lit from the eye and coloured by a distance that its vertices have
/// (world units), seen as `view` has it: by its camera, of its size and background. The scale is
/// logarithmic, from a millionth of the mesh's diagonal, rounded to a power of ten, to a hundredth.
scene::MeasurePicture distance_picture(const scene::Scene& view, geometry::TriangleMesh mesh,
                                       const std::vector<double>& distances);

}  // namespace pellucid::compare
