// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"
#include "scene/view/camera_fit.h"

namespace pellucid::scene {

/// Returns how far what is drawn of an object reaches from its vertices, in world units.
double drawn_radius(const SceneObject& object);

/// Returns the camera that sees the whole scene from that side, as large as it can be in the
/// scene's resolution, with the projection and the vertical angle of the scene's camera.
Camera fitted_camera(const Scene& scene, const ViewDirection& from);

}  // namespace pellucid::scene
