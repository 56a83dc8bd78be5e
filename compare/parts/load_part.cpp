// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/load_part.h"

#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

bool has_halo(const scene::SceneObject& object) {
  const auto* lines = std::get_if<scene::LineObject>(&object.shape);
  return lines && lines->halo;
}

/// A BoundedScene is a scene without its objects' shapes, but for one object alone.
struct BoundedScene {
  scene::Scene scene;
  Box3 bounds;  // of all objects, world
  bool any_halo = false;
};

BoundedScene measure(const fs::path& path, const Progress& progress,
                     const scene::ViewRequest& view) {
  BoundedScene measured;
  measured.scene = scene::load_scene_by_objects(
      path, progress, view, [&](scene::SceneObject& object, std::size_t count) {
        const Box3 box = object.bounds();
        measured.bounds.min = glm::min(measured.bounds.min, box.min);
        measured.bounds.max = glm::max(measured.bounds.max, box.max);
        measured.any_halo |= has_halo(object);
        if (count > 1) object.shape = geometry::TriangleMesh();
      });
  return measured;
}

}  // namespace

groundtruth::ScenePart load_part(const fs::path& path, const Progress& progress,
                                 const scene::ViewRequest& view, const scene::PartNumber& part,
                                 scene::PartOf of) {
  BoundedScene measured = measure(path, progress, view);
  if (measured.scene.objects.size() == 1)
    return groundtruth::take_part(std::move(measured.scene), part, of);
  if (measured.any_halo)
    return groundtruth::take_part(scene::load_scene(path, progress, view), part, of);
  groundtruth::PartCutter cutter(measured.scene, measured.bounds, part, of);
  scene::Scene cut = scene::load_scene_by_objects(
      path, progress, view, [&](scene::SceneObject& object, std::size_t) { cutter.cut(object); });
  groundtruth::WholeScene whole = cutter.whole(cut);
  return {std::move(cut), std::move(whole)};
}

}  // namespace pellucid::compare
