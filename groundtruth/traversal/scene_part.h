// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "groundtruth/rays/view_frame.h"
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

/// A PartCutter cuts a scene's objects down to a part, one after another, and gathers what is to be
/// known of the whole. Beside an object a copy of its positions is in memory meanwhile.
class PartCutter {
 public:
  /// Takes the scene's picture and camera (its objects do not count), the box of all that is drawn,
  /// in world units, and scene::shared_elements() of all objects.
  PartCutter(const scene::Scene& scene, const Box3& bounds, std::vector<std::uint64_t> counts,
             const scene::PartNumber& part);

  /// Cuts the next object. Throws InputError for more primitives than a Crossing counts, and for
  /// coordinates that are too large.
  void cut(scene::SceneObject& object);
  /// Returns what is known once all objects are cut. Throws InputError, with their names from
  /// `scene`, when none of them is in front of the camera.
  WholeScene whole(const scene::Scene& scene) const;

 private:
  ViewFrame frame_;
  scene::Camera camera_;
  scene::DepthBounds depths_;
  std::vector<std::uint64_t> counts_;
  WholeScene whole_;
};

/// Cuts a scene that is in memory down to a part of its primitives. Throws as PartCutter does.
ScenePart take_part(scene::Scene scene, const scene::PartNumber& part,
                    scene::PartOf of = scene::PartOf::all_objects);

}  // namespace pellucid::groundtruth
