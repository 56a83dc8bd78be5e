// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/check_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using scene::SceneHead;
using scene::SceneView;

// Sums of two sides, each of which is at most a picture's largest, are no overflow.
void check_crop(const JsonNode& node, const Crop& crop, const SceneView& view) {
  if (crop.x + crop.width <= view.width && crop.y + crop.height <= view.height) return;
  node.fail(fmt::format(
      "[{}, {}, {}, {}] is not within the picture; accepted: [x, y, width, height] within "
      "{}×{} pixels",
      crop.x, crop.y, crop.width, crop.height, view.width, view.height));
}

void check_probes(const JsonNode& node, std::span<const Pixel> pixels, const SceneView& view) {
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i].x >= view.width || pixels[i].y >= view.height)
      node.elements()[i].fail(fmt::format(
          "[{}, {}] is outside of the picture; accepted: [column, row] within {}×{} pixels",
          pixels[i].x, pixels[i].y, view.width, view.height));
}

void check_path(const JsonNode& node, const fs::path& scene, const SceneHead& head) {
  if (head.camera_path.empty())
    node.fail(fmt::format(
        "\"path\": {} has no camera_path; accepted: one, a number of views, or a list of cameras",
        scene.string()));
}

bool is_one(const scene::Camera& a, const scene::Camera& b) {
  return a.projection == b.projection && scene::camera_text(a) == scene::camera_text(b);
}

/// What of two scenes keeps their pictures from being compared; empty if nothing does.
std::string_view difference(const Views& views, const SceneHead& a, const SceneHead& b) {
  if (a.view.background != b.view.background) return "background";
  if (!views.cameras.empty()) return "";
  if (views.path)
    return std::ranges::equal(a.camera_path, b.camera_path, is_one) ? "" : "camera_path";
  if (!a.has_camera && !b.has_camera) return "";
  const bool same = a.has_camera == b.has_camera && is_one(a.view.camera, b.view.camera);
  return same ? "" : "camera";
}

void check_reference_scene(const JsonNode& node, const fs::path& scene, const fs::path& reference,
                           std::string_view what) {
  if (!what.empty())
    node.fail(fmt::format("{} has another {} than {}; accepted: a scene of the same {}",
                          reference.string(), what, scene.string(), what));
}

SceneHead head_of(const JsonNode& node, const fs::path& scene) {
  return at_place(node, [&] { return scene::read_scene_head(scene); });
}

}  // namespace

void check_scenes(const JsonNode& root, const Study& study) {
  for (const fs::path& scene : study.scenes) {
    const std::string name = scene_name(scene);
    const auto crop = study.crops.find(name);
    const auto probes = study.probes.find(name);
    const auto reference = study.reference_scenes.find(name);
    const bool has_crop = crop != study.crops.end(), has_probes = probes != study.probes.end();
    const bool has_reference = reference != study.reference_scenes.end();
    if (!has_crop && !has_probes && !has_reference && !study.views.path) continue;
    const SceneHead head = head_of(root["scenes"], scene);
    if (has_crop) check_crop(root["crops"][name], crop->second, head.view);
    if (has_probes) check_probes(root["probes"][name], probes->second, head.view);
    if (study.views.path) check_path(root["views"], scene, head);
    if (!has_reference) continue;
    const JsonNode node = root["reference_scene"];
    check_reference_scene(node, scene, reference->second,
                          difference(study.views, head, head_of(node, reference->second)));
  }
}

}  // namespace pellucid::compare
