// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/methods/raytracer.h"

namespace pellucid::groundtruth {

/// MarchMethodOptions are those of the method `march`.
struct MarchMethodOptions {
  MarchOptions march;
  double stop_below = 0;  // a ray, and a march, ends where less than this share shows

  bool operator==(const MarchMethodOptions&) const = default;
};
/// Returns the table of MarchMethodOptions.
const OptionTable<MarchMethodOptions>& march_options();

/// Isosurfaces by ray marching, as published; everything else as in `raytrace`.
const scene::MethodRow& march_method();

}  // namespace pellucid::groundtruth
