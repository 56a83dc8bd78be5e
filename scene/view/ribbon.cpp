// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/ribbon.h"

#include <algorithm>

#include "scene/view/unit_scale.h"

namespace pellucid::scene {

Vec3 line_direction(std::span<const Vec3> points, std::size_t i) {
  const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, points.size() - 1);
  const Vec3 across = points[after] - points[before];
  return across != Vec3(0) ? across : points[after] - points[i];
}

void ribbon_half_widths(std::span<const Vec3> points, double radius, const CameraFrame& frame,
                        Projection projection, std::vector<Vec3>& half_widths) {
  // Below this sine of the angle between line and v, rounding decides where w points.
  constexpr double parallel = 1e-9;
  half_widths.clear();
  half_widths.reserve(points.size());
  Vec3 previous = radius * frame.right;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 t = with_unit_exponent(line_direction(points, i));
    const Vec3 v = with_unit_exponent(projection == Projection::perspective ? points[i] - frame.eye
                                                                            : frame.forward);
    const Vec3 across = glm::cross(t, v);
    const double length = glm::length(across);
    Vec3 w =
        length > parallel * glm::length(t) * glm::length(v) ? (radius / length) * across : previous;
    if (i > 0 && glm::dot(w, previous) < 0) w = -w;
    half_widths.push_back(w);
    previous = w;
  }
}

}  // namespace pellucid::scene
