#include "oit/geometry.h"

#include <array>
#include <cmath>

namespace pellucid {
namespace {

struct Vertex {
  glm::vec3 position;  // see geometry.vert.glsl
  glm::vec4 color;
};
static_assert(sizeof(Vertex) == 28);

// Perspective: what lies nearer to the eye than this, in units of the farthest depth, is clipped.
// Any positive number would do; this one keeps x / w finite in float.
constexpr double nearest = 1e-6;

}  // namespace

Geometry::Geometry(const Gl& gl, const Scene& scene) : Geometry(gl, scene, depth_range(scene)) {}

Geometry::Geometry(const Gl& gl, const Scene& scene, const DepthRange& range)
    : gl_(gl),
      lit_(scene.lighting == Lighting::headlight),
      projection_(scene.camera.projection),
      range_(range),
      array_(gl) {
  const double half = half_height(scene.camera);
  view_unit_ = projection_ == Projection::perspective ? range_.far : half;
  const double y_scale = projection_ == Projection::perspective ? 1 / half : 1;
  clip_scale_ = {float(y_scale * scene.height / scene.width), float(-y_scale)};
  upload(scene);
}

void Geometry::upload(const Scene& scene) {
  const CameraFrame frame = camera_frame(scene.camera);
  std::vector<Vertex> vertices;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;
  for (const SceneObject& object : scene.objects) {
    const auto base = std::uint32_t(vertices.size());
    const TriangleMesh& mesh = object.mesh();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3 x = mesh.positions[i] - frame.eye;
      vertices.push_back(
          {{float(glm::dot(frame.right, x) / view_unit_), float(glm::dot(frame.up, x) / view_unit_),
            float(range_.normalized(glm::dot(frame.forward, x)))},
           mesh.colors[i]});
      if (lit_) {
        const Vec3& n = mesh.normals[i];
        normals.emplace_back(glm::dot(frame.right, n), glm::dot(frame.up, n),
                             glm::dot(frame.forward, n));
      }
    }
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) indices.push_back(base + corner);
  }
  vertices_ = Buffer(gl_, vertices);
  all_ = {std::uint32_t(indices.size() / 3), Buffer(gl_, indices)};
  gl_.VertexArrayVertexBuffer(array_.id(), 0, vertices_.id(), 0, sizeof(Vertex));
  array_.attribute(0, 0, 3, 0);
  array_.attribute(1, 0, 4, sizeof(glm::vec3));
  if (!lit_) return;
  normals_ = Buffer(gl_, normals);
  gl_.VertexArrayVertexBuffer(array_.id(), 1, normals_.id(), 0, sizeof(glm::vec3));
  array_.attribute(2, 1, 3, 0);
}

Defines Geometry::defines() const {
  Defines defines;
  if (lit_) defines.emplace_back("LIT", 1);
  if (projection_ == Projection::orthographic) defines.emplace_back("ORTHOGRAPHIC", 1);
  return defines;
}

void Geometry::set_uniforms(const Program& program) const {
  program.set("clip_scale", clip_scale_);
  // View depth in units of the farthest: z = z0 + z1 d.
  const double z0 = range_.near / range_.far, z1 = (range_.far - range_.near) / range_.far;
  if (projection_ == Projection::perspective) {
    // w = z and z_clip = z - 2 nearest: inside [-w, w] exactly when z >= nearest.
    program.set("clip_w", glm::vec2(z0, z1));
    program.set("clip_z", glm::vec2(z0 - 2 * nearest, z1));
  } else {
    // w = 1 and z_clip = z - 1: inside [-1, 1] exactly when 0 <= z <= 2.
    program.set("clip_w", glm::vec2(1, 0));
    program.set("clip_z", glm::vec2(z0 - 1, z1));
  }
}

void Geometry::draw(const Triangles& triangles) const {
  gl_.BindVertexArray(array_.id());
  gl_.VertexArrayElementBuffer(array_.id(), triangles.indices.id());
  gl_.DrawElements(GL_TRIANGLES, GLsizei(3 * triangles.count), GL_UNSIGNED_INT, nullptr);
}

Triangles Geometry::every(int n) const {
  std::vector<std::array<std::uint32_t, 3>> triangles(all_.count);
  all_.indices.read(triangles.data());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); i += std::size_t(n))
    triangles[kept++] = triangles[i];
  triangles.resize(kept);
  return {std::uint32_t(kept), Buffer(gl_, triangles)};
}

}  // namespace pellucid
