// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/hull_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <limits>

namespace pellucid::compare {
namespace {

constexpr double tolerance = 1e-14;  // squared, of coordinates of about 1

/// Up to four points, without the heap: a picture asks for millions of them.
struct Simplex {
  std::array<Vec3, 4> corners;
  int size = 0;

  void add(const Vec3& corner) { corners[std::size_t(size++)] = corner; }
};

/// The point of a simplex that is nearest to the origin, and the corners that it lies between.
struct Nearest {
  Vec3 point{0};
  Simplex between;
  double distance2 = std::numeric_limits<double>::infinity();
};

/// Of the plane (line, point) through the corners, if it lies between them; at an infinite distance
/// otherwise, and where they span no such plane: then fewer of them do.
Nearest nearest_between(const Simplex& simplex) {
  const Vec3 origin = simplex.corners[0];
  Mat3 gram(1);
  Vec3 right(0);
  double sizes = 1;
  for (int i = 0; i + 1 < simplex.size; ++i) {
    const Vec3 edge = simplex.corners[std::size_t(i) + 1] - origin;
    for (int j = 0; j + 1 < simplex.size; ++j)
      gram[i][j] = glm::dot(edge, simplex.corners[std::size_t(j) + 1] - origin);
    right[i] = -glm::dot(edge, origin);
    sizes *= gram[i][i];
  }
  if (glm::determinant(gram) <= tolerance * sizes) return {};
  const Vec3 weights = glm::inverse(gram) * right;
  if (glm::any(glm::lessThan(weights, Vec3(0))) || weights.x + weights.y + weights.z > 1) return {};
  Vec3 point = origin;
  for (int i = 0; i + 1 < simplex.size; ++i)
    point += weights[i] * (simplex.corners[std::size_t(i) + 1] - origin);
  return {point, simplex, glm::dot(point, point)};
}

/// Tries every face.
Nearest nearest_of(const Simplex& simplex) {
  Nearest best;
  for (unsigned subset = 1; subset < 1u << simplex.size; ++subset) {
    Simplex face;
    for (unsigned i = 0; i < unsigned(simplex.size); ++i)
      if (subset >> i & 1) face.add(simplex.corners[i]);
    const Nearest candidate = nearest_between(face);
    if (candidate.distance2 < best.distance2) best = candidate;
  }
  return best;
}

}  // namespace

double hull_distance(const Vec3& point, std::span<const Vec3> points) {
  Simplex start;
  start.add(points[0] - point);
  Nearest nearest = nearest_of(start);
  // Each round gets nearer, so that rounding alone could keep it going.
  for (int round = 0; round < 64 && nearest.distance2 > tolerance; ++round) {
    if (nearest.between.size == 4) return 0;  // within a tetrahedron, up to rounding
    const auto along = [&](const Vec3& p) { return glm::dot(p - point, nearest.point); };
    const Vec3 beyond =
        *std::min_element(points.begin(), points.end(),
                          [&](const Vec3& a, const Vec3& b) { return along(a) < along(b); });
    if (along(beyond) > nearest.distance2 - tolerance) break;
    Simplex simplex = nearest.between;
    simplex.add(beyond - point);
    const Nearest nearer = nearest_of(simplex);
    if (nearer.distance2 >= nearest.distance2) break;
    nearest = nearer;
  }
  return std::sqrt(nearest.distance2);
}

}  // namespace pellucid::compare
