// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/inspect.h"
#include "app/info/vertices_contents.h"
#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"
#include "scene/scene_fit.h"

namespace pellucid::app {
namespace {

/// Scalars by which an object may be coloured.
std::vector<std::string> scalars_of(const scene::SceneObject& object) {
  std::vector<std::string> names;
  for (const auto& [name, values] : object.vertices().scalars) names.push_back(name);
  return names;
}

/// What one object consists of: a scene of it alone tells.
std::string primitives_of(const scene::SceneObject& object) {
  scene::Scene alone;
  alone.objects.push_back(object);
  return scene::describe_primitives(alone);
}

/// The one radius, or the least and the largest.
nlohmann::ordered_json radius_of(const scene::SceneObject& object) {
  const scene::Radii& radii = object.radii();
  if (!radii.vary()) return radii.largest();
  double least = radii.largest();
  for (std::size_t i = 0; i < object.vertices().positions.size(); ++i)
    least = std::min(least, radii.at(i));
  return {least, radii.largest()};
}

nlohmann::ordered_json describe(const scene::SceneObject& object) {
  const Box3 box = object.bounds();
  FileContents range;
  geometry::Vertices colors;
  colors.colors = object.vertices().colors;
  add_vertices(colors, range);
  nlohmann::ordered_json json{{"name", object.name},
                              {"holds", primitives_of(object)},
                              {"bounds", {{"min", json_of(box.min)}, {"max", json_of(box.max)}}},
                              {"opaque", object.opaque},
                              {"scalars", scalars_of(object)}};
  if (object.lighting) json["lighting"] = name_of(*object.lighting);
  if (object.radii().largest() > 0) json["radius"] = radius_of(object);
  if (!object.vertices().remarks.empty()) json["remarks"] = object.vertices().remarks;
  if (!range.arrays.empty()) {
    const Vec2 opacity = range.arrays.front().ranges.back();
    json["opacities"] = {opacity.x, opacity.y};
  }
  return json;
}

void count(const scene::Scene& scene, FileContents& contents) {
  std::uint64_t points = 0, triangles = 0, lines = 0, segments = 0;
  for (const scene::SceneObject& object : scene.objects) {
    points += object.vertices().positions.size();
    if (const auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape))
      triangles += mesh->triangles.size();
    if (const auto* set = std::get_if<scene::LineObject>(&object.shape)) {
      lines += set->set.line_count();
      segments += set->set.segment_count();
    }
  }
  contents.counts = {{"objects", scene.objects.size()},
                     {"points", points},
                     {"triangles", triangles},
                     {"lines", lines},
                     {"segments", segments}};
}

}  // namespace

FileContents inspect_scene(const std::filesystem::path& path, const Progress& progress) {
  const scene::Scene scene = scene::load_scene(path, progress);
  FileContents contents;
  contents.kind = "scene";
  contents.title = "pellucid-scene, version 1";
  contents.bounds = scene.bounds();
  count(scene, contents);
  contents.more["resolution"] = {scene.width, scene.height};
  contents.more["samples"] = scene::samples_json(scene.samples);
  contents.more["camera"] = scene::camera_json(scene.camera);
  contents.more["camera found"] = scene.provenance.at("camera");
  contents.more["background"] = json_of(scene.background);
  contents.more["lighting"] = name_of(scene.lighting);
  if (!scene.camera_path.empty()) contents.more["camera_path"] = scene.camera_path.size();
  for (const scene::SceneObject& object : scene.objects)
    contents.more["objects"].push_back(describe(object));
  return contents;
}

}  // namespace pellucid::app
