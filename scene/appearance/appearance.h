// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vec.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::scene {

class Colormap;

/// A Scale says how a range is divided: evenly by value, or by the logarithm of the value, which
/// takes a range above 0. There what is not above 0 has the place of the range's smaller end, and
/// counts neither for a range nor for a percentile.
enum class Scale { linear, logarithmic };

/// A ScalarColor colours by a scalar of the vertices through a named map. `range` maps to the ends
/// of the map, and may descend, which turns the map round; without it the range is that of all
/// finite values. NaN gets `nan`.
struct ScalarColor {
  std::string scalar;
  std::string map = "viridis";
  std::optional<Vec2> range;
  std::array<bool, 2> in_percent{};  // which ends of `range` are percentiles, in [0, 100]
  Scale scale = Scale::linear;
  std::shared_ptr<const Colormap> custom = nullptr;  // in the place of `map`
  std::optional<Vec3> nan = std::nullopt;            // in the place of nan_color
};

/// A ScalarOpacity gives the opacity by a scalar of the vertices: linear between the opacities at
/// the ends of the range, which may descend, constant beyond; NaN gets the first opacity. The range
/// is found as a ScalarColor's is.
struct ScalarOpacity {
  std::string scalar;
  Vec2 opacities{0, 1};  // each in [0, 1]
  std::optional<Vec2> range;
  std::array<bool, 2> in_percent{};  // as of a ScalarColor
  Scale scale = Scale::linear;
};

/// An Appearance says how an object is drawn. What is not set stays as the vertices have it.
struct Appearance {
  std::variant<std::monostate, Vec3, ScalarColor> color;        // red, green, blue in [0, 1]
  std::variant<std::monostate, double, ScalarOpacity> opacity;  // in [0, 1]
  /// g of every vertex, in [0, 1]; or the scalar that gives it, mapped from its range to [0, 1].
  std::variant<std::monostate, double, std::string> importance;
};

/// Returns the scalars that colours, opacities and importance are by.
std::vector<std::string> scalars_of(const Appearance& appearance);

/// Returns the values of a scalar. Throws InputError for one that the vertices do not have, with
/// those they have.
const std::vector<double>& find_scalar(const geometry::Vertices& vertices, const std::string& name);

/// Fills `colors` (default: light grey, opaque) and `importance`. Throws InputError for a scalar
/// that the vertices do not have, with those they have, and for an unknown colour map.
void apply_appearance(const Appearance& appearance, geometry::Vertices& vertices);

/// Returns where the value is in the range: 0 at range.x, 1 at range.y, which may be the smaller
/// one; off a range of no width ±infinity. NaN maps to NaN; what is not above 0 has no place on a
/// logarithmic scale and is infinitely far before the smaller end.
double fraction_of(double value, const Vec2& range, Scale scale = Scale::linear);

/// Returns the smallest and the largest finite value; (inf, -inf) when there is none.
Vec2 finite_range(const std::vector<double>& values);

/// Returns a percentile, in [0, 100], of the finite values: linear between two values that follow
/// each other in order (Hyndman, Fan 1996, type 7, as NumPy does); NaN of none.
double percentile_of(std::vector<double> values, double percentile);

/// Returns whether both ends of a ScalarColor's or a ScalarOpacity's range are given as values, so
/// that it is the same whatever the scalar's.
template <class By>
bool has_given_range(const By& by) {
  return by.range && !by.in_percent[0] && !by.in_percent[1];
}

/// Returns the range of a ScalarColor or a ScalarOpacity over the scalar's values, its percentiles
/// found; values are not asked of one that has_given_range(). Throws InputError for a logarithmic
/// range that is not above 0.
///@{
Vec2 range_over(const ScalarColor& by, const std::vector<double>& values);
Vec2 range_over(const ScalarOpacity& by, const std::vector<double>& values);
///@}

/// Fills `normals` with the area-weighted mean of the facets' normals around each vertex, unless
/// the mesh has normals already. Vertices of no facet with an area get +z.
void ensure_normals(geometry::TriangleMesh& mesh);

}  // namespace pellucid::scene
