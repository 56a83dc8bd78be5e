// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "oit/gl/gl_objects.h"
#include "oit/shapes/batch.h"
#include "oit/shapes/view_space.h"

namespace pellucid::oit {

/// Solids are the spheres and the segments of tubes of a scene in buffers, for solid.vert.glsl and
/// solid.glsl: 96 bytes a sphere; 48 a segment of a tube and 48 a point of its line, and 8 for each
/// pair of a line's segments that overlap; where radii of tubes vary, 8 more a segment.
class Solids {
 public:
  /// Uploads them, positions in double in the frame of `view`. Throws InputError where tubes wind
  /// so close that they have too many pairs.
  Solids(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);

  /// Returns where the solids of a kind begin in the buffer.
  std::uint32_t first(ShapeKind kind) const { return kind == ShapeKind::tube ? spheres_ : 0; }
  /// Returns whether a tube's radii vary: its programs need the define TAPERED.
  bool tapered() const { return tapered_; }
  /// Copies opacities in [0, 1] to the points of all tubes.
  void set_tube_opacities(std::span<const float> opacities) const;
  Resources resources() const;

 private:
  std::uint32_t spheres_ = 0;
  bool tapered_ = false;
  BufferTexture solids_, points_, overlaps_;
};

}  // namespace pellucid::oit
