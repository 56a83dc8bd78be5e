// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "oit/gl/bindings.h"
#include "oit/gl/driver_check.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// llvmpipe's largest framebuffer is 16384; a larger one is refused before anything is allocated.
void check_size(const Gl& gl, int width, int height) {
  GLint largest = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw InputError(
        fmt::format("resolution: {} x {}; accepted: 1 … {} each way", width, height, largest));
}

Geometry geometry_of(const GlContext& in, const scene::Scene& scene,
                     const scene::RenderContext& context) {
  const Gl& gl = in.gl();
  check_size(gl, scene.width, scene.height);
  check_driver(in);
  if (!context.depths) return {gl, scene};
  return {gl, scene, *context.depths, primitive_ranges(scene),
          context.part ? *context.part : scene::PartNumber()};
}

Texture texture_of(const Gl& gl, const Image& image) {
  Texture texture(gl, GL_RGBA32F, image.width, image.height);
  texture.write_layer(0, GL_RGBA, GL_FLOAT, image.pixels.data());
  return texture;
}

}  // namespace

Stage::Stage(const scene::Scene& scene, const scene::RenderContext& context)
    : scene_(scene),
      memory_(context.memory),
      context_(context.gl),
      clock_(context_.gl()),
      width_(scene.width),
      height_(scene.height),
      background_(scene.background),
      geometry_(geometry_of(context_, scene, context)),
      no_attributes_(context_.gl()) {
  if (!geometry_.kinds(true).empty()) {
    opaque_.emplace(context_, geometry_, width_, height_);
    record("opaque context", opaque_->bytes());
  }
  if (context.behind) given_behind_ = texture_of(gl(), *context.behind);
  context_.check("uploading the scene");
}

Texture Stage::target(std::string_view name, GLenum format, int layers) {
  Texture texture(gl(), format, width_, height_, layers);
  record(name, texture.bytes());
  return texture;
}

Texture Stage::half_target(std::string_view name, GLenum format, int layers) {
  Texture texture(gl(), format, (width_ + 1) / 2, (height_ + 1) / 2, layers);
  record(name, texture.bytes());
  return texture;
}

GeometryProgram Stage::geometry_program(std::string_view fragment, Defines defines,
                                        const FragmentOpacity& opacity) const {
  for (auto& define : geometry_.defines()) defines.push_back(std::move(define));
  defines.insert(defines.end(), opacity.defines.begin(), opacity.defines.end());
  if (opaque_) defines.emplace_back("OPAQUE_CONTEXT", 1);
  return {context_, geometry_.kinds(false), {fragment, opacity.text}, defines, opacity.resources};
}

Program Stage::screen_program(std::string_view fragment, Defines defines) const {
  if (opaque_ || given_behind_) defines.emplace_back("OPAQUE_CONTEXT", 1);
  Program program(context_, oit_glsl::screen_vert_glsl(), {fragment}, defines);
  program.set_if_used("background", background_);  // where it does not composite, it has none
  return program;
}

void Stage::set_opacities(std::span<const float> of_meshes, std::span<const float> of_lines) {
  geometry_.set_mesh_opacities(of_meshes);
  geometry_.set_line_opacities(of_lines);
  record("opacities of vertices", of_meshes.size_bytes() + 2 * of_lines.size_bytes());
}

void Stage::sample_at(const Vec2& sample) {
  sample_ = sample;
  geometry_.sample_at(sample);
}

void Stage::draw_opaque_context() const {
  if (opaque_) opaque_->draw(background_);
}

Image Stage::behind() const {
  Image image(width_, height_);
  std::fill(image.pixels.begin(), image.pixels.end(), glm::vec4(background_, 0));
  if (opaque_)
    opaque_->picture().read(GL_RGBA, GL_FLOAT, image.pixels.size() * sizeof image.pixels[0],
                            image.pixels.data());
  return image;
}

void Stage::begin(Pass pass, const Resources& of_program) const {
  pass.resources.add(of_program);
  if (opaque_) pass.resources.add(opaque_->resources());
  if (given_behind_)
    pass.resources.add(given_behind_->as_texture(bindings::opaque_picture_texture));
  pass.begin(gl());
}

void Stage::draw_geometry(const Pass& pass, const GeometryProgram& program) const {
  begin(pass, program.resources() + geometry_.resources());
  geometry_.draw(program, pass.target->size());
}

void Stage::draw_geometry(const Pass& pass, const GeometryProgram& program,
                          const Geometry& geometry) const {
  geometry.sample_at(sample_);
  begin(pass, program.resources() + geometry.resources());
  geometry.draw(program, pass.target->size());
}

void Stage::draw_geometry(const Pass& pass, const GeometryProgram& program,
                          const Subset& subset) const {
  begin(pass, program.resources() + geometry_.resources());
  geometry_.draw(program, pass.target->size(), subset);
}

void Stage::draw_screen(const Pass& pass, const Program& program) const {
  begin(pass, {});
  program.use();
  gl().BindVertexArray(no_attributes_.id());
  gl().DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pellucid::oit
