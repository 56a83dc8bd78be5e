// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// RayPredicate for the rays of a packet at once.

#include <array>
#include <cstdint>

#include "groundtruth/rays/exact_sign.h"

namespace pellucid::groundtruth {

/// A PacketPredicate decides which of up to sixteen rays cross a triangle, and where: to the last
/// bit what their RayPredicates and triangle_point() say one by one, computed for all rays side by
/// side. All rays are of one camera.
class PacketPredicate {
 public:
  static constexpr std::size_t width = 16;

  /// Points are TrianglePoints of all rays, lane by lane.
  struct alignas(64) Points {
    std::array<double, width> depth, u, v;
  };

  /// Takes a ray's predicate for the lane, lane 0 always; it has to stay where it is.
  void set(std::size_t lane, const RayPredicate& predicate);

  /// Returns the subset of `lanes` (bit i: lane i) whose rays cross the triangle; `points` then
  /// holds where, by edge functions that are sharpened (see RayPredicate::sharpen).
  std::uint32_t crosses(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t lanes,
                        Points& points) const;

  /// Returns a subset of `lanes` that holds all whose rays meet the ball around `center`, and all
  /// that cross the disc there which is parallel to the picture; few others but where rays run at a
  /// wide angle to the view.
  std::uint32_t may_meet(const Vec3& center, double radius, std::uint32_t lanes) const;

 private:
  std::array<const RayPredicate*, width> predicates_{};
  alignas(64) std::array<double, width> x_{}, y_{}, bound_{}, sharp_from_{};
  alignas(64) std::array<double, width> stretch_{};  // squared length of the direction (x, y, 1)
  double widest_ = 0;                                // the largest |x| or |y|
};

}  // namespace pellucid::groundtruth
