// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace pellucid::scene {

/// Returns whether the opacities of the scene's vertices were optimized, by apply() of
/// optimized_opacities.h. A surface's FlowSource knows nothing of them: who draws by it has to take
/// opacities from the mesh.
bool has_optimized_opacities(const Scene& scene);

}  // namespace pellucid::scene
