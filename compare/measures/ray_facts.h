// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/raster.h"
#include "scene/scene.h"

namespace pellucid::compare {

/// Of the importance g in [0, 1]: a layer of this or more is important, what is less is context.
constexpr double important = 0.5;

/// A ContextOfRay is the context in front of a ray's first important layer, or of the background
/// where it crosses none.
struct ContextOfRay {
  int layers = 0;  // of the context; of none the rest says nothing
  Vec3 color{0};   // the mean of its layers', straight
  Vec3 behind{0};  // of the important layer, straight, or of the background
  /// Between the important layer and the nearest one in front of it, d in [0, 1]; not a number
  /// where the ray crosses no important one.
  double gap = std::numeric_limits<double>::quiet_NaN();
};

/// RayFacts are what measures ask of the ray through each pixel's centre; not a number where it
/// crosses nothing.
struct RayFacts {
  Raster<double> nearest_depth;  // d in [0, 1] of the nearest layer
  Raster<double> shown_depth;  // … of the layer that shows most, by its share α T of the colour
  Raster<double> importance;   // g in [0, 1] of the most important layer
  Raster<ContextOfRay> context;
};

/// Asks all rays of a scene; row 0 is the top.
RayFacts ray_facts(const scene::Scene& scene);

}  // namespace pellucid::compare
