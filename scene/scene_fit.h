// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"
#include "scene/view/camera_fit.h"

namespace pellucid::scene {

/// Returns whether something of an object's vertex may be seen: of a point of radius 0 nothing is.
bool is_drawn(const SceneObject& object, std::size_t i);

/// Shows a camera that is to be fitted all that is drawn of an object.
void show(const SceneObject& object, CameraFit& fit);

/// Returns the camera that looks from this side and sees all that is drawn, by the projection and
/// the shape of the scene's picture; without a side from above the front right corner, as a scene
/// is looked at that says nothing.
Camera fitted_camera(const Scene& scene, const ViewDirection& from = view_directions().front());

/// Returns whether nobody has given the scene's camera, so that it was fitted to what is drawn.
bool has_fitted_camera(const Scene& scene);

}  // namespace pellucid::scene
