#include "integrators/front_particle.h"

namespace pellucid {

Vec3 surface_normal(const FlowPoint& point) {
  // Each first by itself: velocities of 1e±200 would leave the range of the product.
  const double v = glm::length(point.v), w = glm::length(point.w);
  if (!(v > 0) || !(w > 0)) return Vec3(0);
  const Vec3 normal = glm::cross(point.w / w, point.v / v);
  const double sine = glm::length(normal);
  return sine > 1e-9 ? normal / sine : Vec3(0);
}

FrontPoint front_point(const Trajectory& path, double t) {
  const FlowPoint flow = path.at(t);
  return {t, flow, surface_normal(flow)};
}

Separation separation(const FlowPoint& a, const FlowPoint& b) {
  const Vec3 joining = b.x - a.x;
  const double distance = glm::length(joining);
  const double va = glm::length(a.v), vb = glm::length(b.v);
  if (!(va > 0) || !(vb > 0)) return {distance, distance};
  const Vec3 flow = a.v / va + b.v / vb;
  const double length = glm::length(flow);
  if (!(length > 1e-6)) return {distance, distance};
  return {distance, glm::length(joining - glm::dot(joining, flow / length) * (flow / length))};
}

bool are_parting(const FlowPoint& a, const FlowPoint& b) {
  const Vec3 joining = b.x - a.x;
  const double distance = glm::length(joining);
  const double speeds = glm::length(a.v) + glm::length(b.v);
  return distance > 0 && glm::dot(b.v - a.v, joining) > 0.5 * speeds * distance;
}

}  // namespace pellucid
