#pragma once
// On which side of a line does a ray pass? The one decision on which every crossing rests.

#include "core/vec.h"
#include "scene/camera.h"

namespace pellucid {

/// A ray through a point of the picture, and how it moves with that point: the exact tests perturb
/// the point by (+ε, +ε²) pixels to the right and down, infinitesimally, so that no ray meets an
/// edge or a vertex. This is a rasterizer's top-left rule.
struct PictureRay {
  Vec3 origin;
  Vec3 direction;  // component along the viewing axis is 1
  Vec3 step_x;     // what one pixel to the right adds to the direction, or to the origin
  Vec3 step_y;     // one pixel down
  Projection projection = Projection::perspective;
};

/// Values of the three edge functions of a triangle (a, b, c) for a ray (o, d),
///   e[0] = det(d, b - o, c - o),  e[1] = det(d, c - o, a - o),  e[2] = det(d, a - o, b - o):
/// six times the volumes of the tetrahedra that the ray's direction spans with the edges. The
/// point where the ray meets the triangle's plane has the barycentric coordinates e / Σe.
struct EdgeFunctions {
  double e[3];
};

enum class Precision {
  rounded,  // signs as double arithmetic gives them; ties by the top-left rule
  exact     // signs of the exact values: a filter first, unbounded precision where it cannot tell
};

/// True when the perturbed ray's line crosses the triangle; then `edges` holds e, all of one sign
/// (zeros where the unperturbed ray meets an edge). A triangle that the ray's line sees edge-on or
/// that has no area is never crossed. Exact precision makes crossings of a mesh consistent: the
/// line crosses exactly one of the triangles around an edge or vertex that continue each other.
bool crosses(const PictureRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
             Precision precision, EdgeFunctions& edges);

}  // namespace pellucid
