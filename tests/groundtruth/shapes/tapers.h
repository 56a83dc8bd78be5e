// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines of a radius at each point, what rays cross of them, and how deep a place lies in their
// solid.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "groundtruth/traversal/crossing_finder.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {

inline scene::SceneObject tapered_line(
    const std::vector<Vec3>& points, std::vector<double> radii,
    scene::LineObject::Profile profile = scene::LineObject::Profile::tube) {
  scene::LineObject object;
  object.radius = scene::Radii(std::move(radii));
  object.profile = profile;
  object.set.positions = points;
  object.set.offsets = {0, points.size()};
  for (std::size_t i = 0; i < points.size(); ++i)
    object.set.colors.emplace_back(float(i) / float(points.size() - 1), 0, 0, 0.5f);
  return {"line", object};
}

/// Calls see(x, y, crossings) for the rays of all pixels; lengths in depths are the world's.
template <class See>
void see_all(const scene::Scene& scene, const See& see) {
  const CrossingFinder finder(scene, Precision::exact);
  std::vector<Crossing> crossings;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      finder.find(finder.frame().ray(x + 0.5, y + 0.5), crossings);
      for (Crossing& c : crossings) c.depth /= finder.frame().units_per_length();
      see(x, y, crossings);
    }
}

/// Where a concave function of [low, high] is largest, to 1e-10 of the range.
template <class Function>
double place_of_largest(double low, double high, const Function& function) {
  for (int i = 0; i < 57; ++i) {
    const double p = std::lerp(low, high, 1.0 / 3), q = std::lerp(low, high, 2.0 / 3);
    (function(p) < function(q) ? low : high) = function(p) < function(q) ? p : q;
  }
  return 0.5 * (low + high);
}

/// The largest of r(s) - |x - c(s)| over the balls of a segment, s in [0, 1]: above 0 within the
/// hull. It is concave in s, and the largest is concave in x.
inline double depth_within(const Vec3& a, const Vec3& b, double ra, double rb, const Vec3& x) {
  const auto depth = [&](double s) {
    return std::lerp(ra, rb, s) - glm::length(x - glm::mix(a, b, s));
  };
  return std::max({depth(0), depth(1), depth(place_of_largest(0, 1, depth))});
}

}  // namespace pellucid::groundtruth
