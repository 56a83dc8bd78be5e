#pragma once

#include "oit/gl_objects.h"
#include "oit/program.h"
#include "scene/scene.h"
#include "scene/view_depth.h"

namespace pellucid {

/// Some of the scene's triangles.
struct Triangles {
  std::uint32_t count = 0;
  Buffer indices;
};

/// The scene's triangles on the OpenGL side, in the order of the scene: gl_PrimitiveID orders
/// crossings by object, then by triangle.
///
/// A renderer's camera never changes, so vertices are moved into its frame in double and only then
/// rounded to float: neither a scene far from the origin nor a sliver of a depth range loses
/// digits, as it would with a float matrix over world positions.
class Geometry {
 public:
  Geometry(const Gl& gl, const Scene& scene);
  /// `range` is that of the whole picture, where `scene` is a part of it.
  Geometry(const Gl& gl, const Scene& scene, const DepthRange& range);

  /// Defines that the geometry shaders need: LIT, ORTHOGRAPHIC.
  Defines defines() const;
  void set_uniforms(const Program& program) const;
  void draw() const { draw(all_); }
  /// gl_PrimitiveID counts within `triangles`.
  void draw(const Triangles& triangles) const;
  /// Every n-th triangle, copied.
  Triangles every(int n) const;
  std::uint32_t triangle_count() const { return all_.count; }

 private:
  void upload(const Scene& scene);

  const Gl& gl_;
  bool lit_;
  Projection projection_;
  DepthRange range_;
  double view_unit_;      // world units per unit of the positions' x and y
  glm::vec2 clip_scale_;  // see geometry.vert.glsl
  VertexArray array_;
  Buffer vertices_, normals_;
  Triangles all_;
};

}  // namespace pellucid
