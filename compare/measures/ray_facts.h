// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster.h"
#include "scene/scene.h"

namespace pellucid::compare {

/// RayFacts are what measures ask of the ray through each pixel's centre; not a number where it
/// crosses nothing.
struct RayFacts {
  Raster<double> nearest_depth;  // d in [0, 1] of the nearest layer
  Raster<double> importance;     // g in [0, 1] of the most important layer
};

/// Asks all rays of a scene; row 0 is the top.
RayFacts ray_facts(const scene::Scene& scene);

}  // namespace pellucid::compare
