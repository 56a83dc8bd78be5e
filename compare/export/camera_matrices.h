// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::compare {

/// CameraMatrices are what OpenGL makes of a scene's camera. All that is in the picture lies
/// between `near` and `far`, view depths in world units.
struct CameraMatrices {
  Mat4 view;        // view from world: x right, y up, looking along -z
  Mat4 projection;  // clip from view
  double near = 0, far = 1;
  double aspect = 1;  // width over height
};

/// Returns the matrices. `near` and `far` leave a hundredth of the depths' range, or a thousandth
/// of the distance, on either side of it, so that float matrices do not cut anything off.
CameraMatrices camera_matrices(const scene::Scene& scene, const scene::DepthRange& depths);

}  // namespace pellucid::compare
