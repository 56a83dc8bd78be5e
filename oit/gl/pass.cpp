// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/gl/pass.h"

#include <algorithm>
#include <cassert>

#include "oit/gl/bindings.h"

namespace pellucid::oit {
namespace {

void set_blend(const Gl& gl, GLuint attachment, Blend blend) {
  if (blend == Blend::replace) return gl.Disablei(GL_BLEND, attachment);
  gl.Enablei(GL_BLEND, attachment);
  gl.BlendEquationi(attachment, GL_FUNC_ADD);
  if (blend == Blend::add) gl.BlendFunci(attachment, GL_ONE, GL_ONE);
  if (blend == Blend::under) gl.BlendFunci(attachment, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  if (blend == Blend::over) gl.BlendFunci(attachment, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (blend == Blend::transmit) gl.BlendFunci(attachment, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
}

void set_depth_test(const Gl& gl, DepthTest test) {
  if (test == DepthTest::off) return gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(test == DepthTest::less ? GL_LESS : GL_LEQUAL);
}

#ifndef NDEBUG
void empty_units(const Gl& gl) {
  for (GLuint unit = 0; unit < GLuint(bindings::texture_units); ++unit) gl.BindTextureUnit(unit, 0);
  for (GLuint unit = 0; unit < GLuint(bindings::image_units); ++unit)
    gl.BindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  const auto empty = [&](GLenum target, int units) {
    for (int unit = 0; unit < units; ++unit) gl.BindBufferBase(target, GLuint(unit), 0);
  };
  empty(GL_UNIFORM_BUFFER, bindings::uniform_blocks);
  empty(GL_SHADER_STORAGE_BUFFER, bindings::storage_blocks);
  empty(GL_ATOMIC_COUNTER_BUFFER, bindings::atomic_counters);
}
#endif

}  // namespace

Pass::Pass(const Framebuffer& into, std::initializer_list<Blend> list, Resources bound,
           DepthTest test)
    : target(&into), resources(bound), depth_test(test) {
  assert(list.size() > 0 && list.size() <= blends.size());
  std::fill(std::copy(list.begin(), list.end(), blends.begin()), blends.end(), *(list.end() - 1));
}

void Pass::begin(const Gl& gl) const {
  rows ? target->bind(*rows) : target->bind();
  for (int i = 0; i < target->attachments(); ++i) set_blend(gl, GLuint(i), blends[std::size_t(i)]);
  set_depth_test(gl, depth_test);
#ifndef NDEBUG
  empty_units(gl);
#endif
  resources.bind();
}

}  // namespace pellucid::oit
