// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/vec.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::scene {

/// A ScalarColor colours by a scalar of the vertices through a named map. `range` maps to the ends
/// of the map, and may descend, which turns the map round; without it the scalar's own finite range
/// does. NaN gets nan_color.
struct ScalarColor {
  std::string scalar;
  std::string map = "viridis";
  std::optional<Vec2> range;
};

/// A ScalarOpacity gives the opacity by a scalar of the vertices: linear between the opacities at
/// the ends of `range`, which may descend, constant beyond; NaN gets the first opacity. Without a
/// `range` it is the scalar's own finite one.
struct ScalarOpacity {
  std::string scalar;
  Vec2 opacities{0, 1};  // each in [0, 1]
  std::optional<Vec2> range;
};

/// An Appearance says how an object is drawn. What is not set stays as the vertices have it.
struct Appearance {
  std::variant<std::monostate, Vec3, ScalarColor> color;        // red, green, blue in [0, 1]
  std::variant<std::monostate, double, ScalarOpacity> opacity;  // in [0, 1]
  /// g of every vertex, in [0, 1]; or the scalar that gives it, mapped from its range to [0, 1].
  std::variant<std::monostate, double, std::string> importance;
};

/// Fills `colors` (default: light grey, opaque) and `importance`. Throws InputError for a scalar
/// that the vertices do not have, with those they have, and for an unknown colour map.
void apply_appearance(const Appearance& appearance, geometry::Vertices& vertices);

/// Returns where the value is in the range: 0 at range.x, 1 at range.y, which may be the smaller
/// one. A range of one single value maps to 0, NaN to NaN.
double fraction_of(double value, const Vec2& range);

/// Returns the smallest and the largest finite value; (inf, -inf) when there is none.
Vec2 finite_range(const std::vector<double>& values);

/// Fills `normals` with the area-weighted mean of the facets' normals around each vertex, unless
/// the mesh has normals already. Vertices of no facet with an area get +z.
void ensure_normals(geometry::TriangleMesh& mesh);

}  // namespace pellucid::scene
