// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <optional>

#include "oit/gl/gl_objects.h"
#include "oit/gl/resources.h"

namespace pellucid::oit {

/// A Blend says how fragments are combined with what is at the destination.
enum class Blend {
  replace,
  add,      // destination + source
  under,    // premultiplied source under the destination: front to back
  over,     // … over it: back to front
  transmit  // destination * (1 - source): the product of transmittances
};

/// A DepthTest says what passes a target's depth attachment, which keeps the depth of what passed.
enum class DepthTest { off, less, less_or_equal };

/// A Pass is all of OpenGL's state that a draw depends on, besides program and geometry: where it
/// draws, how that is blended, what its shaders find at which unit (bindings.glsl). It is a value,
/// made where the draw is and given to it:
///
///     const Resource sums = sums_.as_texture(bindings::weighted_sums_texture);
///     stage_.draw_screen({picture, {Blend::replace}, sums}, composite_);
///
/// No draw depends on what an earlier one bound: in debug builds every unit that is not listed is
/// emptied first, and two resources at one unit assert. Making one allocates nothing.
struct Pass {
  /// Attachment i of `into` is blended by list[i], the last one for all that follow.
  Pass(const Framebuffer& into, std::initializer_list<Blend> list, Resources bound = {},
       DepthTest test = DepthTest::off);

  /// Returns the same pass that draws into some rows of the target alone.
  Pass in(const Rows& some) const {
    Pass pass = *this;
    pass.rows = some;
    return pass;
  }

  void begin(const Gl& gl) const;

  const Framebuffer* target;    // has to outlive it
  std::array<Blend, 8> blends;  // OpenGL promises so many attachments
  Resources resources;
  DepthTest depth_test;
  std::optional<Rows> rows = std::nullopt;  // of the target; none: all
};

}  // namespace pellucid::oit
