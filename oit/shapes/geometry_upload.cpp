// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/geometry_upload.h"

#include <algorithm>

#include "oit/gl/bindings.h"
#include "oit/shapes/batch.h"
#include "oit/shapes/clip_shapes.h"
#include "scene/view/ribbon.h"
#include "scene/view/unit_scale.h"

namespace pellucid::oit {
namespace {

struct Vertex {
  glm::vec3 position;  // see view.glsl
  glm::vec4 color;
};
static_assert(sizeof(Vertex) == 28);

/// The objects of one kind, in order.
template <class Shape, class Call>
void for_each(const scene::Scene& scene, const Call& call) {
  for (const scene::SceneObject& object : scene.objects)
    if (const auto* shape = std::get_if<Shape>(&object.shape)) call(*shape);
}

/// call(set of ribbons, index of the line's first point, the line's points)
template <class Call>
void for_each_line(const scene::Scene& scene, const Call& call) {
  for_each<scene::LineObject>(scene, [&](const scene::LineObject& lines) {
    if (lines.profile != scene::LineObject::Profile::ribbon) return;
    const geometry::LineSet& set = lines.set;
    const std::span<const Vec3> points(set.positions);
    for (std::size_t k = 0; k < set.line_count(); ++k)
      call(lines, set.offsets[k],
           points.subspan(set.offsets[k], set.offsets[k + 1] - set.offsets[k]));
  });
}

struct Counts {
  std::uint64_t vertices = 0, primitives = 0;
};

Counts count(const scene::Scene& scene, ShapeKind kind) {
  Counts counts;
  for (const scene::SceneObject& object : scene.objects)
    if (kind_of(object) == kind) {
      counts.vertices += object.vertices().positions.size();
      counts.primitives += primitive_count(object);
    }
  return counts;
}

void describe_vertices(const IndexedVertices& v) {
  v.array.source(bindings::vertices_buffer, v.vertices, sizeof(Vertex));
  v.array.attribute(bindings::position_attribute, bindings::vertices_buffer, 3, 0);
  v.array.attribute(bindings::color_attribute, bindings::vertices_buffer, 4, sizeof(glm::vec3));
}

void describe_directions(const IndexedVertices& v, int components) {
  const auto stride = GLsizei(components * sizeof(float));
  v.array.source(bindings::directions_buffer, v.directions, stride);
  v.array.attribute(bindings::direction_attribute, bindings::directions_buffer, components, 0);
}

void describe_importance(const IndexedVertices& v) {
  v.array.source(bindings::importances_buffer, v.importance, sizeof(float));
  v.array.attribute(bindings::importance_attribute, bindings::importances_buffer, 1, 0);
}

/// Of every vertex of a kind, `copies` times.
Buffer importance(const Gl& gl, const scene::Scene& scene, ShapeKind kind, int copies,
                  std::span<const ClippedVertex> clipped = {}) {
  const std::uint64_t n = count(scene, kind).vertices * std::uint64_t(copies) + clipped.size();
  return Buffer::filled<float>(gl, n, [&](float* out) {
    for (const scene::SceneObject& object : scene.objects) {
      if (kind_of(object) != kind) continue;
      const geometry::Vertices& vertices = object.vertices();
      for (std::size_t i = 0; i < vertices.positions.size(); ++i)
        out = std::fill_n(out, copies, vertices.importance.empty() ? 0 : vertices.importance[i]);
    }
    for (const ClippedVertex& vertex : clipped) *out++ = vertex.importance;
  });
}

Vertex* append(const ClippedTriangles& clipped, Vertex* out) {
  for (const ClippedVertex& vertex : clipped.vertices) *out++ = {vertex.position, vertex.color};
  return out;
}

/// Appends the parts of clipped triangles to `all` of a kind, and takes their areas from these.
void append(const ClippedTriangles& clipped, IndexTriangle* all, IndexTriangle* end) {
  for (const ClippedTriangles::Cut& cut : clipped.cuts) all[cut.triangle] = {0, 0, 0};
  std::ranges::copy(clipped.parts, end);
}

void upload_ribbon_directions(const Gl& gl, const scene::Scene& scene, const ViewSpace& view,
                              IndexedVertices& ribbons) {
  using Line = std::span<const Vec3>;
  const std::uint64_t n =
      2 * count(scene, ShapeKind::ribbon).vertices + ribbons.clipped.vertices.size();
  ribbons.directions = Buffer::filled<glm::vec4>(gl, n, [&](glm::vec4* out) {
    std::vector<Vec3> directions;
    for_each_line(scene, [&](const scene::LineObject&, std::uint64_t, Line line) {
      scene::line_directions(line, directions);
      for (const Vec3& direction : directions)
        for (const float across : {-1.f, 1.f})
          *out++ = {view.direction(scene::normalized_or_zero(direction)), across};
    });
    for (const ClippedVertex& vertex : ribbons.clipped.vertices)
      *out++ = {view.direction(vertex.direction), vertex.across};
  });
  describe_directions(ribbons, 4);
}

}  // namespace

IndexedVertices upload_meshes(const Gl& gl, const scene::Scene& scene, const ViewSpace& view) {
  IndexedVertices result(gl);
  result.clipped = clip_meshes(scene, view);
  const ClippedTriangles& clipped = result.clipped;
  Counts n = count(scene, ShapeKind::mesh);
  n.vertices += clipped.vertices.size();
  n.primitives += clipped.parts.size();
  result.vertices = Buffer::filled<Vertex>(gl, n.vertices, [&](Vertex* out) {
    for_each<geometry::TriangleMesh>(scene, [&](const geometry::TriangleMesh& mesh) {
      for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        *out++ = {view.position(mesh.positions[i]), mesh.colors[i]};
    });
    append(clipped, out);
  });
  result.indices = Buffer::filled<IndexTriangle>(gl, n.primitives, [&](IndexTriangle* out) {
    IndexTriangle* const all = out;
    std::uint32_t base = 0;
    for_each<geometry::TriangleMesh>(scene, [&](const geometry::TriangleMesh& mesh) {
      for (const auto& [a, b, c] : mesh.triangles) *out++ = {base + a, base + b, base + c};
      base += std::uint32_t(mesh.positions.size());
    });
    append(clipped, all, out);
  });
  describe_vertices(result);
  if (!scene::is_lit(scene)) return result;
  result.directions = Buffer::filled<glm::vec3>(gl, n.vertices, [&](glm::vec3* out) {
    for_each<geometry::TriangleMesh>(scene, [&](const geometry::TriangleMesh& mesh) {
      for (const Vec3& normal : mesh.normals) *out++ = view.direction(normal);
      // One without, among others, is not lit.
      if (mesh.normals.empty()) out = std::fill_n(out, mesh.positions.size(), glm::vec3(0));
    });
    for (const ClippedVertex& vertex : clipped.vertices) *out++ = view.direction(vertex.direction);
  });
  describe_directions(result, 3);
  return result;
}

IndexedVertices upload_ribbons(const Gl& gl, const scene::Scene& scene, const ViewSpace& view) {
  using Line = std::span<const Vec3>;
  IndexedVertices result(gl);
  result.clipped = clip_ribbons(scene, view);
  const ClippedTriangles& clipped = result.clipped;
  Counts n = count(scene, ShapeKind::ribbon);
  n.vertices = 2 * n.vertices + clipped.vertices.size();
  n.primitives += clipped.parts.size();
  result.vertices = Buffer::filled<Vertex>(gl, n.vertices, [&](Vertex* out) {
    std::vector<Vec3> half_widths;
    for_each_line(scene, [&](const scene::LineObject& lines, std::uint64_t first, Line line) {
      scene::ribbon_half_widths(line, lines.radius.of(first, line.size()), view.frame(),
                                view.projection(), half_widths);
      for (std::size_t i = 0; i < line.size(); ++i)
        for (const Vec3& corner : {line[i] - half_widths[i], line[i] + half_widths[i]})
          *out++ = {view.position(corner), lines.set.colors[first + i]};
    });
    append(clipped, out);
  });
  result.indices = Buffer::filled<IndexTriangle>(gl, n.primitives, [&](IndexTriangle* out) {
    IndexTriangle* const all = out;
    std::uint32_t base = 0;
    for_each_line(scene, [&](const scene::LineObject&, std::uint64_t, Line line) {
      for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
        for (const IndexTriangle& triangle : scene::ribbon_triangles(base + i)) *out++ = triangle;
      base += std::uint32_t(line.size());
    });
    append(clipped, all, out);
  });
  describe_vertices(result);
  if (!scene::is_lit(scene)) return result;
  upload_ribbon_directions(gl, scene, view, result);
  return result;
}

void upload_mesh_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& meshes) {
  meshes.importance = importance(gl, scene, ShapeKind::mesh, 1, meshes.clipped.vertices);
  describe_importance(meshes);
}

void upload_ribbon_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& ribbons) {
  ribbons.importance = importance(gl, scene, ShapeKind::ribbon, 2, ribbons.clipped.vertices);
  describe_importance(ribbons);
}

void upload_opacities(const Gl& gl, std::span<const float> opacities, int copies,
                      IndexedVertices& vertices) {
  const std::vector<ClippedVertex>& clipped = vertices.clipped.vertices;
  const std::uint64_t n = opacities.size() * std::uint64_t(copies) + clipped.size();
  if (vertices.opacity.bytes() == 0) {
    vertices.opacity = Buffer::writable(gl, n * sizeof(float));
    vertices.array.source(bindings::opacities_buffer, vertices.opacity, sizeof(float));
    vertices.array.attribute(bindings::opacity_attribute, bindings::opacities_buffer, 1, 0);
  }
  if (n > 0)
    vertices.opacity.write<float>([&](float* out) {
      for (const float opacity : opacities) out = std::fill_n(out, copies, opacity);
      for (const ClippedVertex& vertex : clipped)
        *out++ = ClippedTriangles::interpolate(
            vertex, [&](std::uint32_t i) { return opacities[i / std::uint32_t(copies)]; });
    });
}

BufferTexture upload_disc_importance(const Gl& gl, const scene::Scene& scene) {
  return {gl, GL_R32F, importance(gl, scene, ShapeKind::disc, 1)};
}

}  // namespace pellucid::oit
