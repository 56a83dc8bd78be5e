// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::geometry {

/// Returns twice the signed area of a triangle, in square units: positive when it turns to the
/// left.
inline double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns the n - 2 triangles, as places in `polygon`, into which a polygon that turns to the left
/// falls; nothing when it runs out of ears, since it crosses itself. Positions are finite and in
/// the unit square around 0, give or take a factor of two; `rounding` is the largest turn that is
/// taken for none when no true ear is left.
///
/// Spikes, at which the polygon runs back, are cut first. A corner is an ear when it turns to the
/// left and no other corner that does not lies in its triangle; corners at the places of its own do
/// not count. Those that may are found in a grid of as many cells as corners: the time is about
/// linear for polygons whose edges are of one size, and quadratic at worst.
std::vector<std::array<std::uint32_t, 3>> clip_ears(std::span<const Vec2> polygon, double rounding);

}  // namespace pellucid::geometry
