// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/polygons/triangulate.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygons/ear_clipping.h"

namespace pellucid::geometry {
namespace {

using Positions = std::span<const Vec3>;
using Corners = std::span<const std::uint32_t>;

double largest(const Vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

/// A polygon in the plane, turning to the left, within 1 of its first corner; empty when it has no
/// plane.
struct Flat {
  std::vector<Vec2> places;
  double coordinate = 0;  // the largest of the corners, in the same unit
};

double extent_of(Positions positions, Corners corners) {
  double extent = 0;
  for (const std::uint32_t corner : corners)
    extent = std::max(extent, largest(positions[corner] - positions[corners[0]]));
  return extent;
}

/// Half of Σ xᵢ × xᵢ₊₁ in units of the extent, around the first corner: nothing over- or
/// underflows.
Vec3 newell_in(double extent, Positions positions, Corners corners) {
  Vec3 sum(0);
  const auto place = [&](std::size_t i) {
    return (positions[corners[i]] - positions[corners[0]]) / extent;
  };
  for (std::size_t i = 2; i < corners.size(); ++i) sum += 0.5 * glm::cross(place(i - 1), place(i));
  return sum;
}

/// Leaves out the coordinate along which the normal is longest: those that stay are the file's own,
/// not rounded by a rotation.
Flat flatten(Positions positions, Corners corners) {
  const double extent = extent_of(positions, corners);
  const Vec3 normal = newell_in(extent, positions, corners);
  Flat flat;
  if (!(largest(normal) > 0) || !std::isfinite(largest(normal))) return flat;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  for (const std::uint32_t corner : corners) {
    const Vec3 x = (positions[corner] - positions[corners[0]]) / extent;
    flat.places.emplace_back(x[u], x[v]);
    flat.coordinate = std::max(flat.coordinate, largest(positions[corner] / extent));
  }
  return flat;
}

/// Whether no triangle of the fan around the first corner turns to the right, by more than the
/// coordinates are rounded: two differences of coordinates up to `coordinate`, times places up
/// to 1.
bool is_fan(const Flat& flat) {
  const double rounding = 0x1p-50 * (1 + flat.coordinate);
  for (std::size_t k = 2; k < flat.places.size(); ++k)
    if (turn(flat.places[0], flat.places[k - 1], flat.places[k]) < -rounding) return false;
  return true;
}

}  // namespace

Vec3 newell_area(Positions positions, Corners corners) {
  const double extent = corners.empty() ? 0 : extent_of(positions, corners);
  return extent > 0 ? newell_in(extent, positions, corners) * extent * extent : Vec3(0);
}

// Files hold floats more often than not, which puts a corner that was straight off its line by
// 2^-24 of its coordinates; it counts as straight when nothing else is left to cut.
void triangulate_polygon(Positions positions, Corners corners,
                         std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() > 3)
    if (const Flat flat = flatten(positions, corners); !flat.places.empty() && !is_fan(flat))
      if (const auto ears = clip_ears(flat.places, 0x1p-22 * (1 + flat.coordinate));
          !ears.empty()) {
        for (const auto& [a, b, c] : ears)
          triangles.push_back({corners[a], corners[b], corners[c]});
        return;
      }
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

}  // namespace pellucid::geometry
