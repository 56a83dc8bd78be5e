// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/solid/solid_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pellucid::oit {
namespace {

using std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Vec2 everything{-infinity, infinity}, nothing{infinity, -infinity};

/// Tangents of directions between two angles from the viewing axis, less than π apart.
Vec2 tangents(double low, double high) {
  const double middle = 0.5 * (low + high), turn = std::remainder(middle, 2 * pi) - middle;
  low += turn;
  high += turn;
  if (low >= 0.5 * pi || high <= -0.5 * pi) return nothing;
  return {low <= -0.5 * pi ? -infinity : std::tan(low),
          high >= 0.5 * pi ? infinity : std::tan(high)};
}

/// From where to where one axis of the picture sees the hull of two circles around a and b, points
/// of the plane of that axis and the viewing axis; the eye is at 0.
Vec2 seen_from_eye(const Vec2& a, const Vec2& b, double radius_a, double radius_b) {
  const double far_a = glm::length(a), far_b = glm::length(b);
  if (!(far_a > radius_a && far_b > radius_b)) return everything;
  const double at_a = std::atan2(a.x, a.y);
  const double at_b = at_a + std::remainder(std::atan2(b.x, b.y) - at_a, 2 * pi);
  const double wide_a = std::asin(radius_a / far_a), wide_b = std::asin(radius_b / far_b);
  const double low = std::min(at_a - wide_a, at_b - wide_b);
  const double high = std::max(at_a + wide_a, at_b + wide_b);
  return high - low < pi ? tangents(low, high) : everything;  // else the eye may be within
}

/// Along which axis a solid is longest in the picture; any will do.
Vec2 axis_of(const ConeSphere& solid, scene::Projection projection) {
  const bool parallel = projection == scene::Projection::orthographic;
  if (!parallel && !(std::min(solid.a.z, solid.b.z) > 0)) return {1, 0};
  const auto seen = [&](const Vec3& x) { return Vec2(x) / (parallel ? 1 : x.z); };
  const Vec2 along = seen(solid.b) - seen(solid.a);
  const double length = glm::length(along);
  return length > 0 && length < infinity ? along / length : Vec2(1, 0);
}

/// The rectangle along `axis` of what `seen` says, an eighth of a pixel wider for what
/// rasterization rounds, and within the picture.
template <class Seen>
PictureRectangle rectangle_along(const Vec2& axis, const ViewSpace& view, const Seen& seen) {
  const double pixel = std::max(2 / (view.clip_scale().x * view.size().x),
                                2 / (view.clip_scale().y * view.size().y));
  // From the middle to a corner, and a pixel for where samples are.
  const double reach = glm::length(1.0 / view.clip_scale()) + pixel;
  const auto along = [&](const Vec2& direction) {
    return glm::clamp(seen(direction) + pixel / 8 * Vec2(-1, 1), -reach, reach);
  };
  const PictureRectangle rectangle{along(axis), along({-axis.y, axis.x}), axis};
  return rectangle.empty() ? PictureRectangle() : rectangle;
}

}  // namespace

PictureRectangle bounds_in_picture(const ConeSphere& solid, const ViewSpace& view) {
  const Vec3 &a = solid.a, &b = solid.b;
  const double radius_a = solid.radius_a, radius_b = solid.radius_b;
  const bool parallel = view.projection() == scene::Projection::orthographic;
  if (!(std::max(a.z + radius_a, b.z + radius_b) > 0)) return {};
  return rectangle_along(axis_of(solid, view.projection()), view, [&](const Vec2& axis) {
    const double on_a = glm::dot(axis, Vec2(a)), on_b = glm::dot(axis, Vec2(b));
    return parallel ? Vec2(std::min(on_a - radius_a, on_b - radius_b),
                           std::max(on_a + radius_a, on_b + radius_b))
                    : seen_from_eye({on_a, a.z}, {on_b, b.z}, radius_a, radius_b);
  });
}

PictureRectangle bounds_in_picture(const std::array<Vec3, 8>& corners, const ViewSpace& view) {
  const bool parallel = view.projection() == scene::Projection::orthographic;
  double nearest = infinity, farthest = -infinity;  // view depths
  for (const Vec3& corner : corners) {
    nearest = std::min(nearest, corner.z);
    farthest = std::max(farthest, corner.z);
  }
  if (!(farthest > 0)) return {};
  return rectangle_along({1, 0}, view, [&](const Vec2& axis) {
    if (!parallel && !(nearest > 0)) return everything;
    Vec2 seen = nothing;
    for (const Vec3& corner : corners) {
      const double at = glm::dot(axis, Vec2(corner)) / (parallel ? 1 : corner.z);
      seen = {std::min(seen.x, at), std::max(seen.y, at)};
    }
    return seen;
  });
}

}  // namespace pellucid::oit
