// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::geometry {

/// Appends the n - 2 triangles of a polygon of n corners, each the number of a position, to
/// `triangles`; of fewer than three corners none. The polygon may be concave, nearly planar, have
/// collinear or repeated corners, and touch itself.
///
/// The polygon is seen along the axis that is nearest to the normal of its Newell plane. Where the
/// fan around its first corner has no triangle that turns against the polygon, that fan is taken;
/// else ears are clipped (G. H. Meisters, Polygons have ears, Amer. Math. Monthly 82, 1975). In
/// both the triangles turn as the polygon does and cover each place as often as the polygon winds
/// around it: once, or not at all, when it does not cross itself. Where no ear is left, because it
/// crosses itself, it becomes the fan, some of whose triangles turn the other way. So does a
/// polygon that is not finite or has no area. Triangles without area are kept.
void triangulate_polygon(std::span<const Vec3> positions, std::span<const std::uint32_t> corners,
                         std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Returns the area of a polygon as a vector along its normal, in square units: that of its Newell
/// plane.
Vec3 newell_area(std::span<const Vec3> positions, std::span<const std::uint32_t> corners);

}  // namespace pellucid::geometry
