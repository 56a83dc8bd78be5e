// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/driver_check.h"

#include <fmt/format.h>

#include "core/error.h"
#include "oit/gl/bindings.h"
#include "oit/gl/pass.h"
#include "oit/gl/program.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

void require(bool good, const GlContext& context, std::string_view what) {
  if (!good)
    throw WorkError(fmt::format("the OpenGL driver {} cannot be used: {}", context.driver(), what));
}

void check_limits(const GlContext& context) {
  const auto limit = [&](GLenum name) {
    GLint value = 0;
    context.gl().GetIntegerv(name, &value);
    return value;
  };
  require(limit(GL_MAX_DRAW_BUFFERS) >= 8, context, "fewer than 8 colour attachments");
  require(limit(GL_MAX_FRAGMENT_IMAGE_UNIFORMS) >= bindings::image_units, context,
          "fewer than 8 images in a fragment shader");
  require(limit(GL_MAX_TEXTURE_IMAGE_UNITS) >= bindings::textures_of_stage, context,
          "fewer than 16 textures in a fragment shader");
  require(limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) >= bindings::texture_units, context,
          "fewer than 18 units of textures");
  require(limit(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS) >= 1, context,
          "no storage blocks in a fragment shader");
  require(limit(GL_MAX_FRAGMENT_ATOMIC_COUNTERS) >= 1, context,
          "no atomic counters in a fragment shader");
}

/// Draws the one pixel twice: it is written, then blended with itself.
void draw_twice(const GlContext& context, const Pass& pass) {
  const Gl& gl = context.gl();
  const Program program(context, oit_glsl::screen_vert_glsl(), {oit_glsl::driver_check_frag_glsl()},
                        {});
  const VertexArray no_attributes(gl);
  pass.begin(gl);
  gl.BindVertexArray(no_attributes.id());
  program.use();
  for (int i = 0; i < 2; ++i) {
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }
  gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace

void check_driver(const GlContext& context) {
  check_limits(context);
  const Gl& gl = context.gl();
  const Texture sum(gl, GL_RGBA32F, 1, 1), head(gl, GL_R32UI, 1, 1);
  const BufferTexture stores(gl, GL_RGBA32UI, 16 * 3);
  const Buffer counter(gl, sizeof(std::uint32_t));
  const Framebuffer target(gl, {{sum}});
  target.clear_all(0);
  head.clear(0);
  stores.buffer().clear(0);
  counter.clear(0);
  draw_twice(context, {target,
                       {Blend::add},
                       {head.as_image(bindings::checked_head_image),
                        stores.as_image(bindings::checked_stores_image),
                        counter.as_atomic_counter(bindings::checked_counter)}});
  context.check("checking the driver");

  float color[4] = {};
  sum.read(GL_RGBA, GL_FLOAT, sizeof color, color);
  require(color[0] == 2e-5f && color[3] == 2e5f, context,
          "blending into float targets is not in float");
  require(counter.read_word(0) == 2, context, "atomic counters do not count");
  std::uint32_t last = 0;
  head.read(GL_RED_INTEGER, GL_UNSIGNED_INT, sizeof last, &last);
  require(last == 2, context, "atomic exchange in an image does not store");
  // The second draw's record holds what the exchange gave back: the first one's number.
  require(stores.buffer().read_word(4 * 2) == 1 && stores.buffer().read_word(4 * 2 + 1) == 7,
          context, "stores into buffer textures are lost");
}

}  // namespace pellucid::oit
