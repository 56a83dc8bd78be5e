// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Does a ray of any origin and direction cross a triangle, decided without rounding?

#include <optional>

#include "core/vec.h"

namespace pellucid::groundtruth {

/// A FreeRay starts anywhere and runs anywhere; the direction has any length but 0.
struct FreeRay {
  Vec3 origin;
  Vec3 direction;
};

/// A TriangleHit is where a ray crosses a triangle (a, b, c).
struct TriangleHit {
  double t;     // the point is origin + t · direction
  double u, v;  // weights of b and c
  int side;     // +1: the ray runs along (b - a) × (c - a); -1: against it
};

/// Returns where the ray crosses the triangle in front of its origin, if it does. What decides is
/// signs of determinants without rounding; where one is 0 the ray is taken to be another one, whose
/// direction is moved by (ε, ε², ε³) and whose origin by (η, η², η³), infinitesimals with η ≪ ε³
/// (Edelsbrunner, Mücke, Simulation of Simplicity, ACM TOG 9 (1990)). That ray meets no edge, no
/// vertex and no plane that it lies in, so of the triangles around an edge or a vertex that
/// continue each other exactly one is crossed, and a closed mesh is crossed an even number of times
/// by every line. A triangle of which two corners are equal is never crossed.
///
/// t, u and v are rounded to a relative error of 2^-20 of their size at worst, and to a few 2^-53
/// where the triangle is not seen edge-on.
std::optional<TriangleHit> cross(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the t of a crossing that cross() has found, rounded once: the same however the
/// triangle's corners are numbered, and for all triangles of one plane.
double exact_t(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace pellucid::groundtruth
