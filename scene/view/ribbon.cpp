// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/ribbon.h"

#include <algorithm>

#include "scene/view/unit_scale.h"

namespace pellucid::scene {

namespace {

using Points = std::span<const Vec3>;

/// The first of the points up to i that lie where i does, and the one behind the last.
std::size_t first_equal(Points points, std::size_t i) {
  while (i > 0 && points[i - 1] == points[i]) --i;
  return i;
}
std::size_t behind_equal(Points points, std::size_t i) {
  const Vec3& x = points[i];
  while (i < points.size() && points[i] == x) ++i;
  return i;
}

/// Of the points [first, behind), which are equal.
Vec3 direction_of(Points points, std::size_t first, std::size_t behind) {
  const Vec3& x = points[first];
  const Vec3& before = first > 0 ? points[first - 1] : x;
  const Vec3& after = behind < points.size() ? points[behind] : x;
  return after != before ? after - before : after - x;
}

}  // namespace

Vec3 line_direction(std::span<const Vec3> points, std::size_t i) {
  return direction_of(points, first_equal(points, i), behind_equal(points, i));
}

void line_directions(std::span<const Vec3> points, std::vector<Vec3>& directions) {
  directions.resize(points.size());
  for (std::size_t first = 0, behind; first < points.size(); first = behind) {
    behind = behind_equal(points, first);
    std::fill(directions.begin() + std::ptrdiff_t(first),
              directions.begin() + std::ptrdiff_t(behind), direction_of(points, first, behind));
  }
}

namespace {

/// Of points of one radius.
void even_half_widths(Points points, double radius, const CameraFrame& frame, Projection projection,
                      std::vector<Vec3>& half_widths) {
  // Below this sine of the angle between line and v, rounding decides where w points.
  constexpr double parallel = 1e-9;
  line_directions(points, half_widths);
  Vec3 previous = radius * frame.right;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 t = with_unit_exponent(half_widths[i]);
    const Vec3 v = with_unit_exponent(projection == Projection::perspective ? points[i] - frame.eye
                                                                            : frame.forward);
    const Vec3 across = glm::cross(t, v);
    const double length = glm::length(across);
    Vec3 w =
        length > parallel * glm::length(t) * glm::length(v) ? (radius / length) * across : previous;
    if (i > 0 && glm::dot(w, previous) < 0) w = -w;
    half_widths[i] = previous = w;
  }
}

}  // namespace

// Sides are found at the line's largest radius: at a radius of 0 none would be told from the other.
void ribbon_half_widths(std::span<const Vec3> points, RadiusSpan radius, const CameraFrame& frame,
                        Projection projection, std::vector<Vec3>& half_widths) {
  const double largest = radius.largest();
  even_half_widths(points, largest, frame, projection, half_widths);
  if (!radius.vary() || largest == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i) half_widths[i] *= radius.at(i) / largest;
}

}  // namespace pellucid::scene
