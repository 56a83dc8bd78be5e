// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/gl/gl_clock.h"
#include "oit/gl/gl_context.h"
#include "oit/gl/gl_objects.h"
#include "oit/gl/pass.h"
#include "oit/gl/program.h"
#include "oit/shapes/geometry.h"
#include "oit/stage/ledger.h"
#include "oit/stage/opaque_context.h"

namespace pellucid::oit {

/// A Stage is what all methods draw on: a context, the scene's geometry, and the means to run a
/// pass. A method makes its programs and targets from it.
class Stage {
 public:
  /// Makes the context and uploads the scene, which has to outlive it. Throws InputError for a
  /// scene or a picture's size that OpenGL does not draw, WorkError when the driver or its memory
  /// does not suffice.
  Stage(const scene::Scene& scene, const scene::RenderContext& context);

  void make_current() const { context_.make_current(); }
  const GlContext& context() const { return context_; }
  const Gl& gl() const { return context_.gl(); }
  const GlClock& clock() const { return clock_; }
  const scene::Scene& scene() const { return scene_; }
  /// Returns what is kept along a camera path; null when the picture stands alone.
  scene::FrameMemory* memory() const { return memory_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::uint64_t pixel_count() const { return std::uint64_t(width_) * height_; }
  const Geometry& geometry() const { return geometry_; }
  /// Uploads the importance of all vertices for programs with the define IMPORTANCE: fragment.glsl
  /// then has importance().
  void upload_importance() { geometry_.upload_importance(scene_); }
  /// Does what Geometry does; `elements` have to outlive the stage.
  void use_elements(const ElementTextures& elements) { geometry_.use_elements(elements); }
  /// Uploads the opacities of the vertices of meshes and of the points of lines, in [0, 1], for
  /// programs with the define OPTIMIZED_VERTICES; the ledger counts them.
  void set_opacities(std::span<const float> of_meshes, std::span<const float> of_lines);
  /// Places the sample of each pixel from here on, in pixels from its top left corner (see
  /// pixel_samples.h): all passes of a picture share it, so that it is no argument of each.
  void sample_at(const Vec2& sample);
  bool has_opaque_context() const { return opaque_.has_value(); }
  /// Returns what lies behind the transparent fragments, as scene::PartialSums::behind() does, once
  /// draw_opaque_context() has drawn it.
  Image behind() const;
  /// Draws what is opaque, before the picture, sampled as the picture will be.
  void draw_opaque_context() const;
  const Ledger& ledger() const { return ledger_; }
  /// Counts what a method allocated by other means than target().
  void record(std::string_view name, std::uint64_t bytes) { ledger_.record(name, bytes); }

  /// Makes a texture of the picture's size and counts it in the ledger. It is a plain texture if
  /// `layers` is 0, otherwise an array.
  Texture target(std::string_view name, GLenum format, int layers = 0);
  /// Makes such a texture of half the picture's width and height, rounded up.
  Texture half_target(std::string_view name, GLenum format, int layers = 0);
  /// Makes a program over the scene's transparent shapes from a fragment shader's body. A pass
  /// takes a fragment only after the shader's call of fragment(), see fragment.glsl.
  GeometryProgram geometry_program(std::string_view fragment, Defines defines = {},
                                   const FragmentOpacity& opacity = {}) const;
  /// Makes a program over every pixel of the picture. What lies behind is set where it is used.
  Program screen_program(std::string_view fragment, Defines defines = {}) const;

  /// Draws the scene's geometry, a geometry of the method's own, or a subset, in a pass: the
  /// target, and the method's own resources. The stage binds what it has itself beside them:
  /// shapes, opaque context, the opacities of the program. Half targets are drawn into by programs
  /// with the define HALF_RESOLUTION: pixel x, y is where 2 x, 2 y and its neighbours to the right
  /// and below are, up to a pixel where the width or height is odd.
  ///@{
  void draw_geometry(const Pass& pass, const GeometryProgram& program) const;
  void draw_geometry(const Pass& pass, const GeometryProgram& program,
                     const Geometry& geometry) const;
  void draw_geometry(const Pass& pass, const GeometryProgram& program, const Subset& subset) const;
  ///@}

  /// Draws every pixel of the pass's target once.
  void draw_screen(const Pass& pass, const Program& program) const;

 private:
  void begin(Pass pass, const Resources& of_program) const;

  const scene::Scene& scene_;
  scene::FrameMemory* memory_;
  GlContext context_;
  GlClock clock_;
  int width_, height_;
  glm::vec3 background_;
  Geometry geometry_;
  Vec2 sample_{0.5};
  VertexArray no_attributes_;
  Ledger ledger_;
  std::optional<OpaqueContext> opaque_;
  std::optional<Texture> given_behind_;  // in the place of opaque objects
};

}  // namespace pellucid::oit
