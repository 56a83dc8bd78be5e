// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "oit/shapes/geometry_program.h"
#include "oit/shapes/geometry_upload.h"

namespace pellucid::oit {

/// Every n-th of the scene's transparent triangles, segments and points.
struct Subset {
  std::uint32_t stride_of_points = 1;
  std::vector<Batch> batches;  // `first` counts within these indices, or is the first point
  Buffer mesh_indices, ribbon_indices;
};

/// The elements of a scene (see scene/elements/elements.h) for element.glsl: patches, then segments
/// of lines, then every point.
struct ElementTextures {
  BufferTexture of_triangle, of_segment;  // which element
  std::uint32_t first_point = 0;          // of the elements
  BufferTexture opacities;                // of every element; the bits of a float

  Resources resources() const;  // for reading
};

/// The scene's meshes, ribbons and discs on the OpenGL side.
class Geometry {
 public:
  /// Throws as make_batches does.
  Geometry(const Gl& gl, const scene::Scene& scene);
  /// `range` is that of the whole picture, where `scene` is a part of it.
  Geometry(const Gl& gl, const scene::Scene& scene, const scene::DepthRange& range);

  /// Defines that the geometry shaders need: LIT, ORTHOGRAPHIC.
  Defines defines() const;
  /// Which there are among the opaque objects, or among the others.
  std::vector<ShapeKind> kinds(bool opaque) const;
  std::uint64_t primitive_count() const;
  /// Uploads the vertices' importance, of the scene that it was made from, for programs with the
  /// define IMPORTANCE.
  void upload_importance(const scene::Scene& scene);
  /// From here on programs may find out elements and their opacities. They have to outlive it.
  void use_elements(const ElementTextures& elements) { elements_ = &elements; }
  /// Of the vertices of all meshes; of the points of all lines. Copied.
  void set_mesh_opacities(std::span<const float> opacities);
  void set_line_opacities(std::span<const float> opacities);
  /// The picture is sampled there, see pixel_samples.h.
  void sample_at(const Vec2& sample) const;

  /// What the shapes' shaders find in any pass that draws them.
  Resources resources() const;
  /// What is transparent, in the order of the scene, in the pass that has begun.
  void draw(const GeometryProgram& program) const { draw_all(program, false); }
  void draw(const GeometryProgram& program, const Subset& subset) const;
  void draw_opaque(const GeometryProgram& program) const { draw_all(program, true); }
  Subset every(std::uint32_t n) const;

 private:
  /// Where a batch's primitives are found.
  struct Source {
    const Buffer* mesh_indices;
    const Buffer* ribbon_indices;
    std::uint32_t stride_of_points;
  };

  void draw_all(const GeometryProgram& program, bool opaque) const;
  void draw_batch(const GeometryProgram& program, const Batch& batch, const Source& source) const;
  void draw_indexed(const IndexedVertices& vertices, const Buffer& indices,
                    const Batch& batch) const;
  void draw_discs(const Program& program, const Batch& batch, std::uint32_t stride) const;
  Source everything() const;

  const Gl& gl_;
  ViewSpace view_;
  scene::Lighting lighting_;
  std::vector<Batch> batches_;
  Buffer uniforms_;
  std::optional<IndexedVertices> meshes_, ribbons_;
  std::optional<BufferTexture> points_, point_importance_;
  const ElementTextures* elements_ = nullptr;
  VertexArray no_attributes_;
};

}  // namespace pellucid::oit
