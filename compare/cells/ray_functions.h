// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sums along a ray that methods approximate as functions of depth.

#include <span>
#include <vector>

#include "groundtruth/sums/ray_sums.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// A RayFunction is a row of the table of sums along a ray: τ(d) and G(d). They have no unit.
struct RayFunction {
  scene::RaySum sum;
  const char* name;   // of measures
  const char* title;  // within a sentence
  const char* symbol;
  /// Returns the exact value at d in [0, 1]. An opaque layer's optical depth is infinite: it ends
  /// at 60, behind which nothing shows.
  double (*exact)(const groundtruth::RaySums& ray, double d);
};

/// Returns the table of these sums.
std::span<const RayFunction> ray_functions();

/// Returns the depths d, evenly from 0 to 1, at which their curves are drawn.
std::vector<double> curve_depths();

/// Returns the exact values at curve_depths().
std::vector<double> exact_curve(const RayFunction& function, const groundtruth::RaySums& ray);

}  // namespace pellucid::compare
