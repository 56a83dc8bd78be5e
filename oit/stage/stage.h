// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/gl_context.h"
#include "oit/gl/gl_objects.h"
#include "oit/gl/pass.h"
#include "oit/gl/program.h"
#include "oit/shapes/geometry.h"
#include "oit/stage/ledger.h"
#include "oit/stage/opaque_context.h"

namespace pellucid::oit {

/// What all methods draw on: a context, the scene's geometry, and the means to run a pass. A method
/// makes its programs and targets from it.
class Stage {
 public:
  /// The scene has to outlive it.
  Stage(const scene::Scene& scene, const scene::RenderContext& context);

  void make_current() const { context_.make_current(); }
  const GlContext& context() const { return context_; }
  const Gl& gl() const { return context_.gl(); }
  const scene::Scene& scene() const { return scene_; }
  /// None: the picture stands alone.
  scene::FrameMemory* memory() const { return memory_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::uint64_t pixel_count() const { return std::uint64_t(width_) * height_; }
  const Geometry& geometry() const { return geometry_; }
  /// For programs with the define IMPORTANCE: fragment.glsl then has importance().
  void upload_importance() { geometry_.upload_importance(scene_); }
  /// See Geometry. For programs with the define OPTIMIZED_VERTICES; counted.
  void use_elements(const ElementTextures& elements) { geometry_.use_elements(elements); }
  void set_opacities(std::span<const float> of_meshes, std::span<const float> of_lines);
  /// From here on pictures are sampled there, see pixel_samples.h: all passes of a picture are, so
  /// that it is no argument of each.
  void sample_at(const Vec2& sample);
  bool has_opaque_context() const { return opaque_.has_value(); }
  /// Before a picture is drawn: what is opaque, sampled as the picture will be.
  void draw_opaque_context() const;
  const Ledger& ledger() const { return ledger_; }
  /// Counts what a method allocated by other means than target().
  void record(std::string_view name, std::uint64_t bytes) { ledger_.record(name, bytes); }

  /// A texture of the picture's size, in the ledger. `layers` 0: a plain texture.
  Texture target(std::string_view name, GLenum format, int layers = 0);
  /// The same for pictures of half the width and height, rounded up.
  Texture half_target(std::string_view name, GLenum format, int layers = 0);
  /// A program over the scene's transparent shapes from a fragment shader's body. A pass takes a
  /// fragment only after the shader's call of fragment(), see fragment.glsl.
  GeometryProgram geometry_program(std::string_view fragment, Defines defines = {},
                                   const FragmentOpacity& opacity = {}) const;
  /// A program over every pixel of the picture. What lies behind is set where it is used.
  Program screen_program(std::string_view fragment, Defines defines = {}) const;

  // Every draw is given the pass that it is: the target, and the method's own resources. The stage
  // binds what it has itself beside them: shapes, opaque context, the opacities of the program.
  //
  // Half targets are drawn into by programs with the define HALF_RESOLUTION: pixel x, y is where
  // 2 x, 2 y and its neighbours to the right and below are, up to a pixel where the width or height
  // is odd.
  void draw_geometry(const Pass& pass, const GeometryProgram& program) const;
  /// A geometry of the method's own.
  void draw_geometry(const Pass& pass, const GeometryProgram& program,
                     const Geometry& geometry) const;
  void draw_geometry(const Pass& pass, const GeometryProgram& program, const Subset& subset) const;
  void draw_screen(const Pass& pass, const Program& program) const;

 private:
  void begin(Pass pass, const Resources& of_program) const;

  const scene::Scene& scene_;
  scene::FrameMemory* memory_;
  GlContext context_;
  int width_, height_;
  glm::vec3 background_;
  Geometry geometry_;
  Vec2 sample_{0.5};
  VertexArray no_attributes_;
  Ledger ledger_;
  std::optional<OpaqueContext> opaque_;
};

}  // namespace pellucid::oit
