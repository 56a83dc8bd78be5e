// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/scene_part.h"

#include <algorithm>

#include "groundtruth/shapes/crossing_geometry.h"

namespace pellucid::groundtruth {

PartCutter::PartCutter(const scene::Scene& scene, const Box3& bounds,
                       std::vector<std::uint64_t> counts, const scene::PartNumber& part)
    : frame_(scene, bounds),
      camera_(scene.camera),
      depths_(scene.camera, scene.width, scene.height),
      counts_(std::move(counts)),
      whole_{part, bounds, {}, 0, {}} {}

void PartCutter::cut(scene::SceneObject& object) {
  const std::size_t index = whole_.first_primitives.size();
  depths_.add(object);
  // An isosurface has no vertices, and would look for its cells.
  if (!std::holds_alternative<scene::Isosurface>(object.shape)) {
    const GeometryContext unlit{frame_, camera_, scene::Lighting::none};
    const auto geometry = make_geometry(object, std::uint32_t(index), unlit);
    whole_.largest = std::max(whole_.largest, geometry->largest_coordinate());
  }
  const bool stays = counts_[index] == 0;  // it is empty, opaque, or has cells
  whole_.first_primitives.push_back(
      stays ? 0 : scene::cut_object(object, scene::share_of(counts_, index, whole_.part)));
}

WholeScene PartCutter::whole(const scene::Scene& scene) const {
  WholeScene whole = whole_;
  whole.depths = depths_.range(scene);
  return whole;
}

ScenePart take_part(scene::Scene scene, const scene::PartNumber& part, scene::PartOf of) {
  std::vector<std::uint64_t> counts;
  for (const scene::SceneObject& object : scene.objects)
    counts.push_back(scene::shared_elements(object, of));
  PartCutter cutter(scene, scene.bounds(), std::move(counts), part);
  for (scene::SceneObject& object : scene.objects) cutter.cut(object);
  WholeScene whole = cutter.whole(scene);
  return {std::move(scene), std::move(whole)};
}

}  // namespace pellucid::groundtruth
