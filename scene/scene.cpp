// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pellucid::scene {
namespace {

struct PrimitiveCounts {
  std::size_t triangles = 0, lines = 0, segments = 0, points = 0, isosurfaces = 0;

  void operator()(const geometry::TriangleMesh& mesh) { triangles += mesh.triangles.size(); }
  void operator()(const LineObject& object) {
    lines += object.set.line_count();
    segments += object.set.segment_count();
  }
  void operator()(const PointObject& object) { points += object.set.positions.size(); }
  void operator()(const Isosurface&) { ++isosurfaces; }
};

const geometry::Vertices& vertices_of(const geometry::TriangleMesh& mesh) { return mesh; }
const geometry::Vertices& vertices_of(const LineObject& object) { return object.set; }
const geometry::Vertices& vertices_of(const PointObject& object) { return object.set; }
const geometry::Vertices& vertices_of(const Isosurface& surface) { return surface.corners; }

}  // namespace

const geometry::Vertices& SceneObject::vertices() const {
  return std::visit([](const auto& s) -> const geometry::Vertices& { return vertices_of(s); },
                    shape);
}

const Radii& SceneObject::radii() const {
  static const Radii none;
  if (const auto* lines = std::get_if<LineObject>(&shape)) return lines->radius;
  if (const auto* points = std::get_if<PointObject>(&shape)) return points->radius;
  return none;
}

Box3 SceneObject::bounds() const {
  const Radii& radius = radii();
  Box3 box;
  if (!radius.vary()) {
    box = vertices().bounds();
    return {box.min - radius.largest(), box.max + radius.largest()};
  }
  const std::vector<Vec3>& x = vertices().positions;
  for (std::size_t i = 0; i < x.size(); ++i) {
    box.extend(x[i] - radius.at(i));
    box.extend(x[i] + radius.at(i));
  }
  return box;
}

Box3 Scene::bounds() const {
  Box3 box;
  for (const SceneObject& object : objects) {
    const Box3 part = object.bounds();
    box.min = glm::min(box.min, part.min);
    box.max = glm::max(box.max, part.max);
  }
  return box;
}

std::optional<Lighting> common_lighting(const Scene& scene) {
  if (scene.objects.empty()) return scene.lighting;
  const Lighting first = lighting_of(scene, scene.objects[0]);
  const bool differ = std::ranges::any_of(scene.objects, [&](const SceneObject& object) {
    return lighting_of(scene, object) != first;
  });
  return differ ? std::nullopt : std::optional(first);
}

bool has_importance(const Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const SceneObject& object) {
    return !object.opaque &&
           std::ranges::any_of(object.vertices().importance, [](float g) { return g > 0; });
  });
}

void fail_at(const Scene& scene, const InputError& error) {
  const std::string_view what = error.what();
  if (scene.file.empty() || what.starts_with(scene.file)) throw error;
  throw InputError(fmt::format("{}: {}", scene.file, what));
}

std::string describe_primitives(const Scene& scene) {
  PrimitiveCounts counts;
  for (const SceneObject& object : scene.objects) std::visit(std::ref(counts), object.shape);
  std::vector<std::string> parts;
  if (counts.triangles) parts.push_back(fmt::format("{} triangles", counts.triangles));
  if (counts.lines)
    parts.push_back(fmt::format("{} lines of {} segments", counts.lines, counts.segments));
  if (counts.points) parts.push_back(fmt::format("{} points", counts.points));
  if (counts.isosurfaces) parts.push_back(fmt::format("{} isosurfaces", counts.isosurfaces));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace pellucid::scene
