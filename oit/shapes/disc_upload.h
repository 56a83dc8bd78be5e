// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/gl_objects.h"
#include "oit/shapes/view_space.h"

namespace pellucid::oit {

/// Uploads centres, radii and colours of all points, 32 bytes a point: see disc.vert.glsl. Throws
/// InputError for a disc in the picture that reaches too far beyond it (see GuardBand).
BufferTexture upload_discs(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);

}  // namespace pellucid::oit
