// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "integrators/front/surface_builder.h"

namespace pellucid::integrators {

/// A FacetBound says what a facet may be like.
struct FacetBound {
  double largest_angle = 180;     // degrees, to the normals at its corners; 180: anything
  double shortest_edge = 0;       // world units: shorter ones are not split
  std::size_t most_vertices = 0;  // new ones: each takes a particle
  std::size_t max_triangles = 0;
};

/// The surface's point at (s, t); nothing when there is none, or none is to be had.
using SurfacePoint = std::function<std::optional<FrontPoint>(double s, double t)>;

/// Mends the facets that stand off the surface. Where a front leans along the flow, the ends of an
/// edge and the next vertex are nearly in line, and the surface's own curvature, not its slope,
/// decides how the triangle stands: it may even be turned over. Three things help, in this order:
/// - The other diagonal of two triangles, first wherever it is shorter, which leads step by step to
///   the edges across the flow that a leaning front has not; then wherever the facets face better.
/// - A vertex on the longest edge, since half as long an edge bends a quarter as much: on the
///   border, where there is no other diagonal.
/// - Where edges would have to become shorter than they may, or too many, facets on the border are
///   trimmed off that are less than the shortest edge wide.
/// Returns how many were trimmed.
std::size_t mend_facets(SurfaceBuilder& builder, const FacetBound& bound,
                        const SurfacePoint& point_at);

}  // namespace pellucid::integrators
