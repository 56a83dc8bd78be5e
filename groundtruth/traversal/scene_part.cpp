// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/scene_part.h"

#include <algorithm>

#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {
namespace {

/// Of all objects but isosurfaces, which have none and would look for their cells.
double largest_coordinate(const scene::Scene& scene, const Box3& bounds) {
  const ViewFrame frame(scene, bounds);
  const GeometryContext context{frame, scene.camera, scene.lighting};
  double largest = 0;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    if (!std::holds_alternative<scene::Isosurface>(scene.objects[i].shape))
      largest =
          std::max(largest, make_geometry(scene.objects[i], i, context)->largest_coordinate());
  return largest;
}

}  // namespace

ScenePart take_part(scene::Scene scene, const scene::PartNumber& part) {
  WholeScene whole{part, scene.bounds(), scene::depth_range(scene), 0, {}};
  whole.largest = largest_coordinate(scene, whole.bounds);
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    whole.first_primitives.push_back(scene::cut_object(scene.objects[i], i, part));
  return {std::move(scene), std::move(whole)};
}

}  // namespace pellucid::groundtruth
