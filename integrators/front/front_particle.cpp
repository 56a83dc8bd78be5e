// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/front_particle.h"

#include <algorithm>
#include <cmath>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {
namespace {

Vec3 surface_normal(const Vec3& w, const Vec3& direction) {
  const Vec3 normal = glm::cross(direction_of(w), direction);
  const double sine = glm::length(normal);
  return sine > 1e-9 ? normal / sine : Vec3(0);
}

}  // namespace

FrontPoint front_point(const Trajectory& path, double t) {
  FrontPoint point;
  point.t = t;
  point.flow = path.at(t);
  point.speed = magnitude(point.flow.v);
  point.direction = direction_of(point.flow.v);
  point.normal = surface_normal(point.flow.w, point.direction);
  return point;
}

void FrontParticle::go_on() {
  if (next->t > head.t) {
    if (path.are_same(next->flow.x, head.flow.x)) next->vertex = head.vertex;
    head = *next;
  }
  next.reset();
}

Separation separation(const FrontPoint& a, const FrontPoint& b) {
  const Vec3 joining = b.flow.x - a.flow.x;
  const double distance = glm::length(joining);
  // The mean direction; two that are opposite, or rest, have none.
  const Vec3 flow = a.direction + b.direction;
  const double length2 = glm::dot(flow, flow);
  if (a.speed == 0 || b.speed == 0 || !(length2 > 1e-12)) return {distance, distance};
  return {distance, glm::length(joining - (glm::dot(joining, flow) / length2) * flow)};
}

bool are_parting(const FrontPoint& a, const FrontPoint& b) {
  const Vec3 joining = b.flow.x - a.flow.x;
  // Who is ahead on nearly the same way, and faster since the flow speeds up, leaves the other one
  // behind for a while, and does not part from it: each ribbon's ends have times of their own.
  if (glm::dot(a.flow.v, joining) > 0 || glm::dot(b.flow.v, joining) < 0) return false;
  const double along = glm::dot(b.flow.v - a.flow.v, joining);
  return along > 0 && along > 0.5 * (a.speed + b.speed) * glm::length(joining);
}

bool are_parting(const Abreast& two) { return two.comparable && are_parting(two.a, two.b); }

}  // namespace pellucid::integrators
