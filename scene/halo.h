// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace pellucid::scene {

/// Puts the halos of the scene's lines, seen by its camera, behind their lines in the order of its
/// objects, in place of those that are there. They are the depth-dependent halos of Everts, Bekker,
/// Roerdink, Isenberg, Depth-Dependent Halos: Illustrative Rendering of Dense Line Data, IEEE TVCG
/// 15 (2009). Throws InputError for a camera that camera_frame() refuses.
///
/// From each rim of a ribbon (see ribbon.h) a strip of triangles reaches `width` further out, and
/// recedes by `depth` along the line of sight: it hides lines far behind, and not those that cross
/// close by. It is a mesh with the line's opacity and importance, which every method draws, and
/// faces the light. The paper displaces depths in a shader, by any function; this one is linear.
void place_halos(Scene& scene);

}  // namespace pellucid::scene
