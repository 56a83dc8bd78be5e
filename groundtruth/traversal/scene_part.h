// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "scene/parts/scene_part.h"
#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid::groundtruth {

/// A WholeScene is what has to be known of a scene so that rays meet a part of it as they meet the
/// whole, to the last bit.
struct WholeScene {
  scene::PartNumber part;
  Box3 bounds;               // of all objects, world: gives the unit of view coordinates
  scene::DepthRange depths;  // of all that is drawn
  double largest = 0;        // of CrossingGeometry::largest_coordinate(): gives bounds on rounding
  std::vector<std::uint32_t> first_primitives;  // in the whole, of each object's part
};

/// A ScenePart is a part of a scene's primitives, all objects in their places, some of them empty.
struct ScenePart {
  scene::Scene scene;
  WholeScene whole;
};

/// Cuts a scene down to a part of its primitives. While it does so a copy of the positions of the
/// largest object is in memory beside the scene. Throws InputError when nothing of the whole is in
/// front of the camera, and for more primitives than a Crossing counts.
ScenePart take_part(scene::Scene scene, const scene::PartNumber& part);

}  // namespace pellucid::groundtruth
