// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/guard_band.h"

#include <algorithm>
#include <cmath>

namespace pellucid::oit {
namespace {

constexpr double guard = 16;  // halves of the picture; lengths of the depth range

/// Where a line meets the plane from which its ends have these heights, the first not negative.
ClippedCorner between(const ClippedCorner& inside, const ClippedCorner& outside, double height,
                      double depth) {
  const double t = height / (height - depth), rest = -depth / (height - depth);
  return {rest * inside.position + t * outside.position,
          rest * inside.weights + t * outside.weights};
}

}  // namespace

double GuardBand::height(unsigned plane, const Vec3& p, double reach) const {
  if (plane == 4)
    return p.z - (reach > guard ? 0.5 - reach : std::max(view_.nearest_drawn(), 0.5 - reach));
  if (plane == 5) return 0.5 + reach - p.z;
  const int axis = int(plane / 2);
  const double side = view_.clip_scale()[axis] * p[axis];
  return reach * view_.w(p.z) + (plane % 2 == 0 ? side : -side);
}

bool GuardBand::holds(const Vec3& position) const {
  for (unsigned plane = 0; plane < plane_count; ++plane)
    if (!(height(plane, position, guard) >= 0)) return false;
  return true;
}

bool GuardBand::misses_picture(const std::array<Vec3, 3>& corners) const {
  for (unsigned plane = 0; plane < plane_count; ++plane)
    if (std::ranges::all_of(corners, [&](const Vec3& p) { return height(plane, p, 1) < 0; }))
      return true;
  return false;
}

bool GuardBand::disc_misses_picture(const Vec3& center, double radius) const {
  if (!(center.z >= view_.nearest_drawn() && center.z <= 1.5)) return true;
  for (int axis = 0; axis < 2; ++axis)
    if (view_.clip_scale()[axis] * (std::abs(center[axis]) - radius) > view_.w(center.z))
      return true;
  return false;
}

bool GuardBand::holds_disc(const Vec3& center, double radius) const {
  const double reach = 1e4 * view_.w(center.z);
  for (int axis = 0; axis < 2; ++axis)
    if (!(view_.clip_scale()[axis] * (std::abs(center[axis]) + radius) <= reach)) return false;
  return true;
}

// A cut between corners of size s is off by 1e-16 s across the plane, and not at all along an edge
// through the picture's middle or along an axis. Step by step, each a millionth of the one before,
// it comes out right however far away the corners are. The steps are the same for all triangles, so
// that a cut depends on its edge alone.
void GuardBand::clip(const std::array<Vec3, 3>& corners, std::vector<ClippedCorner>& part) const {
  constexpr int steps = 17;  // from beyond the farthest corner, 1e100
  part.clear();
  if (misses_picture(corners)) return;
  part = {{corners[0], {1, 0, 0}}, {corners[1], {0, 1, 0}}, {corners[2], {0, 0, 1}}};
  for (int step = steps; step >= 0; --step)
    for (unsigned plane = 0; plane < plane_count; ++plane)
      clip(plane, std::ldexp(guard, 20 * step), part);
  if (part.size() < 3) part.clear();
}

// Sutherland and Hodgman (1974), Reentrant polygon clipping. A cut is made from the end within to
// the one without, whichever comes first: the neighbour across the edge makes the same.
void GuardBand::clip(unsigned plane, double reach, std::vector<ClippedCorner>& part) const {
  thread_local std::vector<ClippedCorner> whole;
  whole.swap(part);
  part.clear();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const ClippedCorner &a = whole[i], &b = whole[(i + 1) % whole.size()];
    const double at_a = height(plane, a.position, reach), at_b = height(plane, b.position, reach);
    if (at_a >= 0) part.push_back(a);
    if (at_a >= 0 && at_b < 0) part.push_back(between(a, b, at_a, at_b));
    if (at_a < 0 && at_b >= 0) part.push_back(between(b, a, at_b, at_a));
  }
}

}  // namespace pellucid::oit
