// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/opaque_context.h"

#include "oit/gl/bindings.h"
#include "oit/gl/pass.h"
#include "oit_glsl.h"

namespace pellucid::oit {

OpaqueContext::OpaqueContext(const GlContext& context, const Geometry& geometry, int width,
                             int height)
    : gl_(context.gl()),
      geometry_(geometry),
      picture_(gl_, GL_RGBA32F, width, height),
      keys_(gl_, GL_RG32UI, width, height),
      depth_(gl_, GL_DEPTH_COMPONENT32F, width, height),
      target_(gl_, {{picture_}, {keys_}, {depth_}}),
      program_(context, geometry.kinds(true), {oit_glsl::opaque_context_frag_glsl()},
               geometry.defines()) {}

void OpaqueContext::draw(const glm::vec3& background) const {
  target_.clear(0, {background, 0});
  keys_.clear(~0u);  // nothing there: follows every fragment
  target_.clear_depth(1);
  Pass(target_, {Blend::replace}, geometry_.resources(), DepthTest::less).begin(gl_);
  geometry_.draw_opaque(program_, target_.size());
}

Resources OpaqueContext::resources() const {
  return {picture_.as_texture(bindings::opaque_picture_texture),
          keys_.as_texture(bindings::opaque_keys_texture)};
}

}  // namespace pellucid::oit
