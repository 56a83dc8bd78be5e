// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace pellucid::scene {

/// OptimizedOpacities are the opacities of least energy, in [0, 1], that a method found for a
/// picture: of the vertices of all meshes, of the points of all lines, and of all points, each
/// object after object in the order of the scene, opaque ones included.
struct OptimizedOpacities {
  std::vector<float> of_meshes, of_lines, of_points;
};

/// Makes the opacities those of the scene, so that any method composites them: each vertex's own
/// opacity is multiplied by its optimized one, and importance, which has had its say, is taken
/// away. `by` says in the scene's provenance what found them.
void apply(const OptimizedOpacities& opacities, const std::string& by, Scene& scene);

}  // namespace pellucid::scene
