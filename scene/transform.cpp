// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/transform.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/error.h"
#include "scene/view/unit_scale.h"

namespace pellucid::scene {
namespace {

/// Cosine and sine; of multiples of 90° without the rounding of π.
Vec2 cosine_and_sine(double degrees) {
  const double turned = std::remainder(degrees, 360);
  if (std::fmod(turned, 90) == 0) {
    const int quarter = int(turned / 90);
    return {quarter == 0             ? 1
            : std::abs(quarter) == 2 ? -1
                                     : 0,
            std::abs(quarter) == 1 ? quarter : 0};
  }
  const double angle = turned * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

/// Rodrigues' formula: c I + s [n]× + (1 - c) n nᵀ.
Mat3 turn(const Vec3& axis, double degrees) {
  const Vec3 n = normalized_or_zero(axis);
  const Vec2 cs = cosine_and_sine(degrees);
  const Mat3 cross(Vec3(0, n.z, -n.y), Vec3(-n.z, 0, n.x), Vec3(n.y, -n.x, 0));  // by columns
  return cs.x * Mat3(1) + cs.y * cross + (1 - cs.x) * glm::outerProduct(n, n);
}

}  // namespace

Mat3 linear_part(const Transform& transform) {
  Mat3 m = turn(transform.axis, transform.degrees);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= transform.scale[axis];
  return m;
}

void transform(const Transform& by, geometry::Vertices& vertices) {
  const Mat3 m = linear_part(by);
  for (Vec3& x : vertices.positions) {
    x = m * x + by.translation;
    const bool fits = std::abs(x.x) < geometry::coordinate_limit &&
                      std::abs(x.y) < geometry::coordinate_limit &&
                      std::abs(x.z) < geometry::coordinate_limit;
    if (!fits) throw InputError("moves a coordinate beyond 1e300; accepted: less");
  }
  // (R S)⁻ᵀ = R S⁻¹.
  const Mat3 of_normals = linear_part({1.0 / by.scale, by.axis, by.degrees, Vec3(0)});
  for (Vec3& n : vertices.normals) n = normalized_or_zero(of_normals * n);
}

}  // namespace pellucid::scene
