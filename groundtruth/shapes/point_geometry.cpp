// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/point_geometry.h"

#include <cmath>

#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {

PointGeometry::PointGeometry(const scene::PointObject& points, std::uint32_t index,
                             const GeometryContext& context)
    : set_(points.set),
      radius_(points.radius.of(0, points.set.positions.size())),
      units_per_length_(context.frame.units_per_length()),
      index_(index),
      frame_(context.frame),
      lighting_(context.lighting) {
  check_count(set_.positions.size(), "points");
}

std::uint32_t PointGeometry::box_count() const {
  return static_cast<std::uint32_t>(set_.positions.size());
}

Fragment PointGeometry::shade(const Crossing& crossing, const Vec3&) const {
  Fragment fragment = point_blend(crossing).fragment(set_);
  fragment.color = scene::lit(lighting_, fragment.color, std::abs(crossing.v));
  return fragment;
}

double PointGeometry::importance(const Crossing& crossing) const {
  return point_blend(crossing).importance(set_);
}

}  // namespace pellucid::groundtruth
