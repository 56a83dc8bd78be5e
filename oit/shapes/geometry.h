// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "oit/shapes/geometry_program.h"
#include "oit/shapes/geometry_upload.h"
#include "oit/shapes/isosurface/isosurfaces.h"
#include "oit/shapes/solid/solids.h"

namespace pellucid::oit {

/// A Subset is every n-th of the scene's transparent triangles, segments and points.
struct Subset {
  std::uint32_t stride_of_points = 1;
  std::vector<Batch> batches;  // `first` counts within these indices, or is the first point
  Buffer mesh_indices, ribbon_indices;
};

/// ElementTextures hold the elements of a scene (see scene/elements/elements.h) for element.glsl:
/// patches, then segments of lines, then every point.
struct ElementTextures {
  BufferTexture of_triangle, of_segment;  // which element
  std::uint32_t first_point = 0;          // of the elements
  BufferTexture opacities;                // of every element; the bits of a float

  Resources resources() const;  // for reading
};

/// A Geometry is the scene's meshes, ribbons, discs, spheres, tubes and isosurfaces on the OpenGL
/// side.
class Geometry {
 public:
  /// Uploads the scene. Throws as make_batches() does, and as scene::depth_range().
  Geometry(const Gl& gl, const scene::Scene& scene);
  /// Uploads a `part` of a scene whose depths have the `range`, and whose objects have these
  /// `places` in the order of the scene; of isosurfaces, which are not cut, what has that `number`.
  Geometry(const Gl& gl, const scene::Scene& part, const scene::DepthRange& range,
           std::span<const PrimitiveRange> places, const scene::PartNumber& number = {});

  /// Returns the defines that the geometry shaders need: LIT, PHONG, LIT_BY_OBJECT, ORTHOGRAPHIC,
  /// TAPERED, FADING_DEGREE.
  Defines defines() const;
  /// Returns which kinds there are among the opaque objects, or among the others.
  std::vector<ShapeKind> kinds(bool opaque) const;
  std::uint64_t primitive_count() const { return primitive_count_; }
  /// Uploads the vertices' importance, of the scene that it was made from, for programs with the
  /// define IMPORTANCE.
  void upload_importance(const scene::Scene& scene);
  /// Lets programs find out elements and their opacities from here on. `elements` have to outlive
  /// the geometry.
  void use_elements(const ElementTextures& elements) { elements_ = &elements; }
  /// Copies the opacities, in [0, 1], of the vertices of all meshes, or of the points of all lines.
  ///@{
  void set_mesh_opacities(std::span<const float> opacities);
  void set_line_opacities(std::span<const float> opacities);
  ///@}

  /// Places the sample of each pixel, in pixels from its top left corner; see pixel_samples.h.
  void sample_at(const Vec2& sample) const;

  /// Returns what the shapes' shaders find in any pass that draws them.
  Resources resources() const;
  /// Draws what is transparent, or a subset of it, in the order of the scene, in the pass that has
  /// begun, whose target has `size` pixels.
  ///@{
  void draw(const GeometryProgram& program, const glm::vec2& size) const {
    draw_all(program, size, false);
  }
  void draw(const GeometryProgram& program, const glm::vec2& size, const Subset& subset) const;
  ///@}

  /// Draws what is opaque, in the order of the scene, likewise.
  void draw_opaque(const GeometryProgram& program, const glm::vec2& size) const {
    draw_all(program, size, true);
  }
  /// Returns every n-th transparent primitive, from the first.
  Subset every(std::uint32_t n) const;

 private:
  /// A Source says where a batch's primitives are found.
  struct Source {
    const Buffer* mesh_indices;
    const Buffer* ribbon_indices;
    std::uint32_t stride_of_points;
  };
  /// A LineRun is the number of points of lines of one kind that follow each other.
  struct LineRun {
    ShapeKind kind;
    std::size_t points;
  };

  /// Returns those of the opacities of all lines' points that are of a kind.
  std::vector<float> opacities_of(std::span<const float> line_opacities, ShapeKind kind) const;
  /// Lets the parts of clipped triangles be drawn in their place.
  void draw_parts(ShapeKind kind, const IndexedVertices& vertices);
  void draw_all(const GeometryProgram& program, const glm::vec2& size, bool opaque) const;
  void draw_batch(const GeometryProgram& program, const glm::vec2& size, const Batch& batch,
                  const Source& source) const;
  void draw_indexed(const IndexedVertices& vertices, const Buffer& indices,
                    const Batch& batch) const;
  void draw_discs(const Program& program, const Batch& batch, std::uint32_t stride) const;
  void draw_cast(const Program& program, const Batch& batch, std::uint32_t stride) const;
  /// Puts those of isosurfaces, cut, in the place of their batches.
  void place_isosurfaces();
  Source everything() const;

  const Gl& gl_;
  ViewSpace view_;
  std::optional<scene::Lighting> lighting_;  // of all objects; nothing: by object
  std::vector<Batch> batches_;
  std::uint64_t primitive_count_ = 0;
  Buffer uniforms_;
  std::optional<IndexedVertices> meshes_, ribbons_;
  std::optional<BufferTexture> points_, point_importance_;
  std::optional<Solids> solids_;
  std::optional<Isosurfaces> isosurfaces_;
  std::vector<LineRun> lines_;
  const ElementTextures* elements_ = nullptr;
  VertexArray no_attributes_;
};

}  // namespace pellucid::oit
