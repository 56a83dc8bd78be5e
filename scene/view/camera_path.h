// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/view/camera.h"

namespace pellucid::scene {

/// Returns `frames` cameras, at least 2: the first is `camera`, the last has gone `degrees` around
/// the target, about `up`, counterclockwise seen from its tip.
std::vector<Camera> orbit(const Camera& camera, double degrees, int frames);

/// Returns `frames` cameras, at least 2, from the first key to the last, at equal steps from key to
/// key: all numbers are linear between them. Throws InputError for fewer than two keys and for keys
/// of different projections.
std::vector<Camera> between_keys(const std::vector<Camera>& keys, int frames);

/// A CameraMotion says how far a camera has moved.
struct CameraMotion {
  double degrees = 0;   // between the viewing axes
  double distance = 0;  // between the eyes, world units
};
/// Returns how far the camera moved from one frame to another.
CameraMotion motion(const Camera& from, const Camera& to);

}  // namespace pellucid::scene
