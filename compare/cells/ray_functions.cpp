// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/ray_functions.h"

#include <algorithm>

namespace pellucid::compare {
namespace {

constexpr int curve_intervals = 512;

/// An opaque layer's optical depth is infinite; nothing shows behind this.
constexpr double deepest = 60;

constexpr RayFunction functions[] = {
    {scene::RaySum::optical_depth, "optical_depth", "optical depth", "τ(d)",
     [](const groundtruth::RaySums& ray, double d) {
       return std::min(ray.optical_depth(d), deepest);
     }},
    {scene::RaySum::importance, "importance", "importance", "G(d)",
     [](const groundtruth::RaySums& ray, double d) { return ray.importance_sum(d); }}};

}  // namespace

std::span<const RayFunction> ray_functions() { return functions; }

std::vector<double> curve_depths() {
  std::vector<double> d;
  for (int i = 0; i <= curve_intervals; ++i) d.push_back(double(i) / curve_intervals);
  return d;
}

std::vector<double> exact_curve(const RayFunction& function, const groundtruth::RaySums& ray) {
  std::vector<double> values;
  for (const double d : curve_depths()) values.push_back(function.exact(ray, d));
  return values;
}

}  // namespace pellucid::compare
