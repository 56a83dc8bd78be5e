// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/isosurface.h"

namespace pellucid::oit {

/// A ScaleNumbers says where a scalar lies in a range, of what its samples are kept as; see
/// surface_look.glsl.
struct ScaleNumbers {
  double kind = 0;                // SCALE_…
  double factor = 0, offset = 0;  // kept -> fraction; of a logarithmic range -> over its first end
  double length = 0;              // ln of its last end over its first
};

/// A SurfaceLook is what surface_look.glsl reads of an isosurface, in this order.
struct SurfaceLook {
  Vec3 color{0};
  double opacity = 1;
  double first_stop = 0,
         stop_count = 0;  // of its colour map, four numbers each: place in [0, 1], colour
  ScaleNumbers color_scale;
  Vec3 nan_color{0};
  ScaleNumbers fading_scale;
  Vec2 opacities{0};       // at the ends of the range
  Vec3 hole{0};            // world axes, from the eye
  double hole_radius = 0;  // world; 0: none
};
static_assert(sizeof(SurfaceLook) == 23 * sizeof(double));

/// Returns a surface's look, whose `first_stop` is where its stops will be put: `first`; appends
/// these to `stops`. A hole that is the inside of a mesh is none.
SurfaceLook look_of(const scene::Isosurface& surface, const Vec3& eye, std::size_t first,
                    std::vector<double>& stops);

}  // namespace pellucid::oit
