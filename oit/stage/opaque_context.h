// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/shapes/geometry.h"

namespace pellucid::oit {

/// An OpaqueContext is the nearest opaque fragment of every pixel: it takes the background's place,
/// and what follows it in the order of compositing (by depth, then by primitive) is hidden in every
/// method. Equal depths are told apart because the depth test keeps the first that was submitted.
class OpaqueContext {
 public:
  OpaqueContext(const GlContext& context, const Geometry& geometry, int width, int height);

  std::uint64_t bytes() const { return picture_.bytes() + keys_.bytes() + depth_.bytes(); }
  void draw(const glm::vec3& background) const;
  /// Returns the colour and 1 of every pixel that has one, else the background's colour and 0.
  const Texture& picture() const { return picture_; }
  /// Returns what programs with the define OPAQUE_CONTEXT find in composite.glsl and fragment.glsl.
  Resources resources() const;

 private:
  const Gl& gl_;
  const Geometry& geometry_;
  Texture picture_, keys_, depth_;
  Framebuffer target_;
  GeometryProgram program_;
};

}  // namespace pellucid::oit
