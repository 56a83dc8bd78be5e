// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "scene/view/camera.h"
#include "scene/view/radii.h"

namespace pellucid::scene {

/// Returns the line's direction at point i, of any length: the difference of the nearest points
/// before and after it that lie elsewhere, one-sided at the ends and where the line turns straight
/// back. So a point that is there twice changes nothing. 0 where all points are equal.
Vec3 line_direction(std::span<const Vec3> points, std::size_t i);

/// Makes line_direction() of every point, in linear time. Overwrites `directions`.
void line_directions(std::span<const Vec3> points, std::vector<Vec3>& directions);

/// Makes a strip of a line, facing the eye: at point i it reaches from x_i - w_i to x_i + w_i with
///   w = radius · (t × v) / |t × v|,
/// the radius that of the point, t the line_direction() at the point, v the direction from the eye
/// to the point (perspective) or the viewing axis (orthographic). w_i is turned to the side of
/// w_(i-1), so that the strip does not cross itself where the line turns away from the eye.
/// Neighbouring segments share their corners: the strip has no gap at a joint. It has no mitre
/// either: the joint is as wide as the line halfway between two segments' directions, so that a
/// strip that turns by the angle φ is cos(φ / 2) of its width across at the corner.
///
/// Ground truth and every method draw this one shape. Overwrites `half_widths`, world units; where
/// a line stands still or runs along v, w_i points as w_(i-1), or along the camera's right. Where a
/// radius is 0 the strip ends in a tip.
void ribbon_half_widths(std::span<const Vec3> points, RadiusSpan radius, const CameraFrame& frame,
                        Projection projection, std::vector<Vec3>& half_widths);

/// Returns the two triangles of the segment from point i to i + 1, as indices of the corners
/// 2 i (x_i - w_i), 2 i + 1 (x_i + w_i), 2 i + 2, 2 i + 3. Over all segments of an object, counted
/// from line to line, triangle 2 k + j is triangle j of segment k.
constexpr std::array<std::array<std::uint32_t, 3>, 2> ribbon_triangles(std::uint32_t i) {
  return {{{2 * i, 2 * i + 1, 2 * i + 3}, {2 * i, 2 * i + 3, 2 * i + 2}}};
}

}  // namespace pellucid::scene
