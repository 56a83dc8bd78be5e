// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// On which side of an edge does a ray pass? The one decision on which every crossing rests.

#include <cmath>

#include "core/vec.h"
#include "groundtruth/rays/view_frame.h"

namespace pellucid::groundtruth {

/// EdgeFunctions are those of a triangle (a, b, c) for a ray. In view coordinates, sheared so that
/// the ray becomes the z-axis, a vertex lies at
///   a' = (a.x - x a.z, a.y - y a.z)   (perspective)   or   (a.x - x, a.y - y)   (orthographic),
/// and e[0] = b' × c', e[1] = c' × a', e[2] = a' × b'. For a perspective ray these are the
/// determinants det(d, b, c), … of its direction d = (x, y, 1). The ray meets the triangle's plane
/// at the barycentric coordinates e / Σe.
struct EdgeFunctions {
  double e[3];
};

/// A Precision says by which arithmetic crossings are decided.
enum class Precision {
  fast,     // as rounded, but meshes as Embree intersects them, in float: edges may count twice, or
            // not
  rounded,  // signs as double arithmetic gives them; ties by the top-left rule
  exact     // signs of the exact values: a filter first, unbounded precision where it cannot tell
};

/// A RayPredicate decides crossings of one ray with triangles and discs, in view coordinates.
class RayPredicate {
 public:
  /// No coordinate that it is asked about is larger than `largest` in size, in units.
  RayPredicate(const PictureRay& ray, double largest, Precision precision);

  /// Returns true when the ray's line crosses the triangle; then `edges` holds e, all of one sign.
  /// Where the ray meets an edge or a vertex, its picture point is taken to lie (ε, ε²) pixels to
  /// the right and down, infinitesimally: a rasterizer's top-left rule. A triangle that is seen
  /// edge-on or has no area is never crossed. With exact precision the ray crosses exactly one of
  /// the triangles around an edge or vertex that continue each other.
  bool crosses(const Vec3& a, const Vec3& b, const Vec3& c, EdgeFunctions& edges) const;

  /// Computes the edge functions of a triangle that the ray crosses without rounding, where
  /// rounding could move a barycentric coordinate e / Σe by more than 3 · 2^-20: of triangles that
  /// are seen narrower than that leaves their edge functions digits. With exact precision alone.
  void sharpen(const Vec3& a, const Vec3& b, const Vec3& c, EdgeFunctions& edges) const {
    if (std::abs(edges.e[0] + edges.e[1] + edges.e[2]) < sharp_from_) recompute(a, b, c, edges);
  }
  /// Returns from which size of Σe on sharpen() leaves edge functions as they are.
  double sharp_from() const { return sharp_from_; }

  /// Returns true when the ray's line crosses the disc around `center` that is parallel to the
  /// picture; then `squared_distance` is from ray to centre in the disc's plane. A ray that meets
  /// the rim crosses where it moves inwards when it moves to the right: on the left half. Radius
  /// and coordinates are at most `largest`, the centre lies in front of the eye.
  bool crosses_disc(const Vec3& center, double radius, double& squared_distance) const;

  const PictureRay& ray() const { return ray_; }
  /// Returns a bound on the rounding error of an edge function: one further from 0 has its sign.
  double bound() const { return bound_; }
  /// Decides as crosses() where not all of `edges`, as computed in double, lie beyond the bound on
  /// one side.
  bool crosses_uncertain(const Vec3& a, const Vec3& b, const Vec3& c, EdgeFunctions& edges) const;

 private:
  void recompute(const Vec3& a, const Vec3& b, const Vec3& c, EdgeFunctions& edges) const;

  PictureRay ray_;
  Precision precision_;
  double bound_;
  double sharp_from_;
};

}  // namespace pellucid::groundtruth
