// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/picture_frustum.h"

#include <algorithm>

namespace pellucid::scene {
namespace {

/// How far an interval of numbers is from 0.
double distance_from_zero(double low, double high) { return std::max({low, -high, 0.0}); }

}  // namespace

PictureFrustum::PictureFrustum(const Camera& camera, int width, int height)
    : frame_(camera_frame(camera)),
      projection_(camera.projection),
      half_(half_height(camera) * width / height, half_height(camera)) {}

Vec3 PictureFrustum::from_world(const Vec3& x) const {
  const Vec3 p = x - frame_.eye;
  return {glm::dot(frame_.right, p), glm::dot(frame_.up, p), glm::dot(frame_.forward, p)};
}

double PictureFrustum::reach(double z) const {
  const double half = std::max(half_.x, half_.y);
  return std::max(z, projection_ == Projection::perspective ? half * z : half);
}

double PictureFrustum::height(unsigned plane, const Vec3& p) const {
  if (plane == 4) return p.z;
  const unsigned axis = plane / 2;
  const double reach =
      projection_ == Projection::perspective ? half_[int(axis)] * p.z : half_[int(axis)];
  return plane % 2 == 0 ? reach - p[int(axis)] : reach + p[int(axis)];
}

unsigned PictureFrustum::outcode(const Vec3& p) const {
  unsigned code = 0;
  for (unsigned plane = 0; plane < plane_count; ++plane)
    if (height(plane, p) < 0) code |= 1u << plane;
  return code;
}

// Sutherland and Hodgman (1974), Reentrant polygon clipping: plane by plane.
DepthInterval PictureFrustum::depths(std::span<const Vec3> polygon) const {
  thread_local std::vector<Vec3> part, clipped;
  part.assign(polygon.begin(), polygon.end());
  for (unsigned plane = 0; plane < plane_count; ++plane) {
    clipped.clear();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec3 &a = part[i], &b = part[(i + 1) % part.size()];
      const double at_a = height(plane, a), at_b = height(plane, b);
      if (at_a >= 0) clipped.push_back(a);
      if ((at_a < 0) != (at_b < 0)) clipped.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    part.swap(clipped);
  }
  DepthInterval interval;
  for (const Vec3& p : part) interval.extend({p.z, p.z});
  return interval;
}

DepthInterval PictureFrustum::depths(const Box3& box) const {
  const Vec2 aside(distance_from_zero(box.min.x, box.max.x),
                   distance_from_zero(box.min.y, box.max.y));
  double nearest = std::max(box.min.z, 0.0);
  for (int axis = 0; axis < 2; ++axis)
    if (projection_ == Projection::perspective)
      nearest = std::max(nearest, aside[axis] / half_[axis]);  // where the frustum is wide enough
    else if (aside[axis] > half_[axis])
      return {};
  return nearest <= box.max.z ? DepthInterval{nearest, box.max.z} : DepthInterval{};
}

}  // namespace pellucid::scene
