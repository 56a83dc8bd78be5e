// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "oit/gl/gl_objects.h"
#include "oit/shapes/batch.h"
#include "oit/shapes/view_space.h"
#include "scene/parts/scene_part.h"

namespace pellucid::oit {

/// Isosurfaces are those of a scene in buffers, for isosurface.vert.glsl and isosurface.glsl: the
/// pieces of which they are made, once for every crossing that a ray from the eye may have in one.
/// A piece takes 80 bytes a crossing, and 64 of the surface's values (of levels that fade more),
/// 64 for each scalar that colours or fades it, all in double.
class Isosurfaces {
 public:
  /// Cuts and uploads them, in the frame of `view`; of transparent ones the `part`'s share of their
  /// cells. Throws InputError for more than the driver's textures hold, and for a hole that is the
  /// inside of a mesh.
  Isosurfaces(const Gl& gl, const scene::Scene& scene, const ViewSpace& view,
              const scene::PartNumber& part);

  /// Returns the batches of an isosurface in the place of that which make_batches() made, `index`
  /// counting the isosurfaces of the scene: of its pieces of degree one along each axis, then of
  /// its others; none of no pieces.
  std::vector<Batch> batches(std::size_t index, const Batch& whole) const;
  /// Returns the largest degree of a piece along an axis: its programs need it as the define
  /// FADING_DEGREE.
  int degree() const { return degree_; }
  Resources resources() const;

 private:
  /// A Run is a surface's crossings in the buffer.
  struct Run {
    std::uint32_t first, count;  // of pieces of degree one
    std::uint32_t fading_count;  // of the others, which follow
  };

  std::vector<Run> runs_;
  int degree_ = 1;
  BufferTexture pieces_, numbers_;
};

}  // namespace pellucid::oit
