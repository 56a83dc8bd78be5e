// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/elements/optimized_opacities.h"

#include <cassert>
#include <span>

#include "scene/elements/opacity_source.h"

namespace pellucid::scene {
namespace {

constexpr const char* made_by = "opacities";  // in the provenance

/// Takes the vertices' opacities from the front of `opacities`.
void take(std::span<const float>& opacities, geometry::Vertices& vertices) {
  assert(vertices.colors.size() == vertices.positions.size());
  assert(vertices.colors.size() <= opacities.size());
  for (std::size_t i = 0; i < vertices.colors.size(); ++i) vertices.colors[i].a *= opacities[i];
  opacities = opacities.subspan(vertices.colors.size());
  vertices.importance.clear();
}

/// Takes each shape's vertices' opacities from those of its kind. No isosurface has vertices.
struct Take {
  std::span<const float> of_meshes, of_lines, of_points;

  void operator()(geometry::TriangleMesh& mesh) { take(of_meshes, mesh); }
  void operator()(LineObject& lines) { take(of_lines, lines.set); }
  void operator()(PointObject& points) { take(of_points, points.set); }
  void operator()(Isosurface&) {}
};

}  // namespace

void apply(const OptimizedOpacities& opacities, const std::string& by, Scene& scene) {
  Take take{opacities.of_meshes, opacities.of_lines, opacities.of_points};
  for (SceneObject& object : scene.objects) std::visit(take, object.shape);
  scene.provenance[made_by] = by;
}

bool has_optimized_opacities(const Scene& scene) { return scene.provenance.contains(made_by); }

}  // namespace pellucid::scene
