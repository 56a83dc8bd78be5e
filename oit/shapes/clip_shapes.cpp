// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/clip_shapes.h"

#include "scene/view/ribbon.h"
#include "scene/view/unit_scale.h"

namespace pellucid::oit {
namespace {

/// The vertices of a kind; a point of a line has two.
std::uint32_t vertex_count(const scene::Scene& scene, ShapeKind kind) {
  std::size_t count = 0;
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == kind) count += object.vertices().positions.size();
  return std::uint32_t(count) * primitives_of_unit(kind);
}

Corner corner_of(const geometry::Vertices& vertices, std::size_t i) {
  Corner corner;
  corner.world = vertices.positions[i];
  corner.color = vertices.colors[i];
  if (i < vertices.normals.size()) corner.direction = vertices.normals[i];
  if (i < vertices.importance.size()) corner.importance = vertices.importance[i];
  return corner;
}

/// Walks through the triangles of one kind, object by object.
class ShapeClipper {
 public:
  ShapeClipper(const scene::Scene& scene, const ViewSpace& view, ShapeKind kind)
      : view_(view), clipper_(view, vertex_count(scene, kind)) {}

  void add(const scene::SceneObject& object) {
    object_ = &object.name;
    if (const auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape)) add(*mesh);
    if (const auto* lines = std::get_if<scene::LineObject>(&object.shape)) add(*lines);
  }
  ClippedTriangles take() { return clipper_.take(); }

 private:
  using Line = std::span<const Vec3>;

  void add(const geometry::TriangleMesh& mesh) {
    held_.clear();
    for (const Vec3& x : mesh.positions) held_.push_back(clipper_.holds(x));
    for (const IndexTriangle& triangle : mesh.triangles)
      add(triangle, [&](std::uint32_t i) {
        Corner corner = corner_of(mesh, i);
        corner.vertex = first_vertex_ + i;
        return corner;
      });
    first_vertex_ += std::uint32_t(mesh.positions.size());
  }

  void add(const scene::LineObject& lines) {
    const std::span<const Vec3> points(lines.set.positions);
    for (std::size_t k = 0; k < lines.set.line_count(); ++k) {
      const std::size_t first = lines.set.offsets[k];
      add(lines, first, points.subspan(first, lines.set.offsets[k + 1] - first));
    }
  }

  void add(const scene::LineObject& lines, std::size_t first, Line line) {
    scene::ribbon_half_widths(line, lines.radius.of(first, line.size()), view_.frame(),
                              view_.projection(), half_widths_);
    scene::line_directions(line, directions_);
    held_.clear();
    for (std::uint32_t i = 0; i < 2 * line.size(); ++i)
      held_.push_back(clipper_.holds(ribbon_corner(line, i)));
    for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
      for (const IndexTriangle& triangle : scene::ribbon_triangles(i))
        add(triangle, [&](std::uint32_t j) {
          Corner corner = corner_of(lines.set, first + j / 2);
          corner.world = ribbon_corner(line, j);
          corner.direction = scene::normalized_or_zero(directions_[j / 2]);
          corner.across = j % 2 == 0 ? -1 : 1;
          corner.vertex = first_vertex_ + j;
          return corner;
        });
    first_vertex_ += 2 * std::uint32_t(line.size());
  }

  Vec3 ribbon_corner(Line line, std::uint32_t i) const {
    return i % 2 == 0 ? line[i / 2] - half_widths_[i / 2] : line[i / 2] + half_widths_[i / 2];
  }

  template <class CornerOf>
  void add(const IndexTriangle& triangle, const CornerOf& corner_of_vertex) {
    const auto [a, b, c] = triangle;
    if (!held_[a] || !held_[b] || !held_[c])
      clipper_.clip(triangle_, {corner_of_vertex(a), corner_of_vertex(b), corner_of_vertex(c)},
                    *object_);
    ++triangle_;
  }

  const ViewSpace& view_;
  TriangleClipper clipper_;
  const std::string* object_ = nullptr;  // whose turn it is
  std::uint32_t triangle_ = 0, first_vertex_ = 0;
  std::vector<bool> held_;  // of one object's, or line's, vertices: within the guard band
  std::vector<Vec3> half_widths_, directions_;
};

ClippedTriangles clip_all(const scene::Scene& scene, const ViewSpace& view, ShapeKind kind) {
  ShapeClipper clipper(scene, view, kind);
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == kind) clipper.add(object);
  return clipper.take();
}

}  // namespace

ClippedTriangles clip_meshes(const scene::Scene& scene, const ViewSpace& view) {
  return clip_all(scene, view, ShapeKind::mesh);
}

ClippedTriangles clip_ribbons(const scene::Scene& scene, const ViewSpace& view) {
  return clip_all(scene, view, ShapeKind::ribbon);
}

}  // namespace pellucid::oit
