// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/rays/exact_sign.h"

namespace pellucid::groundtruth {

/// A TrianglePoint is where a ray crosses a triangle (a, b, c): its view depth, in units, and the
/// weights of b and c, in [0, 1] but for rounding.
struct TrianglePoint {
  /// The unperturbed ray runs along the triangle where all edge functions are 0: its centre stands
  /// for the crossing. (Divided by the compiler: elsewhere rounding modes forbid it.)
  static constexpr double middle = 1.0 / 3;

  double depth, u, v;
};

/// Returns where a ray with the edge functions `edges`, which crosses the triangle, does so.
inline TrianglePoint triangle_point(const EdgeFunctions& edges, const Vec3& a, const Vec3& b,
                                    const Vec3& c) {
  const double sum = edges.e[0] + edges.e[1] + edges.e[2];
  const double u = sum != 0 ? edges.e[1] / sum : TrianglePoint::middle;
  const double v = sum != 0 ? edges.e[2] / sum : TrianglePoint::middle;
  return {a.z + u * (b.z - a.z) + v * (c.z - a.z), u, v};
}

}  // namespace pellucid::groundtruth
