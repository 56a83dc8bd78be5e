// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/load_part.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files/files_read.h"
#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

bool has_halo(const scene::SceneObject& object) {
  const auto* lines = std::get_if<scene::LineObject>(&object.shape);
  return lines && lines->halo;
}

/// The row of what is shared out: opaque objects stay whole where they hide what others hold.
std::vector<std::uint64_t> row_of(std::vector<std::uint64_t> counts, const scene::Scene& scene,
                                  scene::PartOf of) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (scene.objects[i].opaque && of == scene::PartOf::transparent_objects) counts[i] = 0;
  return counts;
}

/// A PartReader reads those objects of a scene of which a part has a share.
class PartReader {
 public:
  PartReader(const fs::path& path, const scene::PartNumber& part, scene::PartOf of,
             const SceneBounds& bounds)
      : path_(path), part_(part), of_(of), bounds_(bounds) {}

  groundtruth::ScenePart read(const Progress& progress, scene::ViewRequest view) {
    if (!view.view.empty())
      throw InputError("--view: beside --bounds; accepted: none, since bounds know their camera");
    // What the call says of the camera goes over what was fitted then, as it did then.
    const scene::Camera known = scene::camera_of_text(bounds_.camera, {});
    view.camera =
        scene::camera_text(view.camera.empty() ? known : scene::camera_of_text(view.camera, known));
    const FilesRead read;
    groundtruth::ScenePart cut;
    cut.whole = {part_, bounds_.box, bounds_.depths, bounds_.largest, {}};
    cut.scene = head(view);
    check(cut.scene);
    counts_ = row_of(bounds_.counts, cut.scene, of_);
    cut.scene = scene::load_scene_by_objects(
        path_, progress, view,
        [&](scene::SceneObject& object, std::size_t) { take(object, cut.whole); },
        [&](std::size_t index, bool opaque) { return is_wanted(index, opaque); });
    check_unchanged(bounds_, read.paths());
    return cut;
  }

 private:
  /// The scene without any shape.
  scene::Scene head(const scene::ViewRequest& view) const {
    return scene::load_scene_by_objects(path_, {}, view, {},
                                        [](std::size_t, bool) { return false; });
  }

  void check(const scene::Scene& scene) const {
    const std::string camera = scene::camera_text(scene.camera);
    if (camera != bounds_.camera || scene.width != bounds_.width || scene.height != bounds_.height)
      throw InputError(fmt::format(
          "{}: --bounds are of the camera {} and {} x {} pixels; accepted: the same for the part, "
          "here {} and {} x {}",
          path_.string(), bounds_.camera, bounds_.width, bounds_.height, camera, scene.width,
          scene.height));
    if (scene.objects.size() != bounds_.counts.size())
      throw InputError(
          fmt::format("{}: --bounds are of {} objects, the scene has {}; accepted: "
                      "bounds of the scene as it is",
                      path_.string(), bounds_.counts.size(), scene.objects.size()));
  }

  /// An isosurface counts none, and is shared out where its cells are found.
  bool is_wanted(std::size_t index, bool opaque) const {
    if (opaque && of_ == scene::PartOf::transparent_objects) return true;
    if (bounds_.counts[index] == 0) return true;
    const scene::Share share = scene::share_of(counts_, index, part_);
    return share.begin < share.end;
  }

  void take(scene::SceneObject& object, groundtruth::WholeScene& whole) const {
    const std::size_t index = whole.first_primitives.size();
    const bool stays = counts_[index] == 0 || !is_wanted(index, object.opaque);
    whole.first_primitives.push_back(
        stays ? 0 : scene::cut_object(object, scene::share_of(counts_, index, part_)));
  }

  const fs::path& path_;
  const scene::PartNumber& part_;
  scene::PartOf of_;
  const SceneBounds& bounds_;
  std::vector<std::uint64_t> counts_;
};

}  // namespace

MeasuredScene measure_scene(const fs::path& path, const Progress& progress,
                            const scene::ViewRequest& view) {
  MeasuredScene measured;
  measured.scene = scene::load_scene_by_objects(
      path, progress, view, [&](scene::SceneObject& object, std::size_t count) {
        const Box3 box = object.bounds();
        measured.bounds.min = glm::min(measured.bounds.min, box.min);
        measured.bounds.max = glm::max(measured.bounds.max, box.max);
        measured.counts.push_back(scene::shared_elements(object, scene::PartOf::all_objects));
        measured.any_halo |= has_halo(object);
        if (count > 1) object.shape = geometry::TriangleMesh();
      });
  return measured;
}

groundtruth::ScenePart load_part(const fs::path& path, const Progress& progress,
                                 const scene::ViewRequest& view, const scene::PartNumber& part,
                                 scene::PartOf of, const SceneBounds* known) {
  if (known) return PartReader(path, part, of, *known).read(progress, view);
  MeasuredScene measured = measure_scene(path, progress, view);
  if (measured.scene.objects.size() == 1)
    return groundtruth::take_part(std::move(measured.scene), part, of);
  if (measured.any_halo)
    return groundtruth::take_part(scene::load_scene(path, progress, view), part, of);
  groundtruth::PartCutter cutter(measured.scene, measured.bounds,
                                 row_of(measured.counts, measured.scene, of), part);
  scene::Scene cut = scene::load_scene_by_objects(
      path, progress, view, [&](scene::SceneObject& object, std::size_t) { cutter.cut(object); });
  groundtruth::WholeScene whole = cutter.whole(cut);
  return {std::move(cut), std::move(whole)};
}

}  // namespace pellucid::compare
