#include "integrators/front_particle.h"

#include <algorithm>

namespace pellucid {

std::optional<double> next_vertex_time(Trajectory& path, double t, double move,
                                       FieldSampler& sampler) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const FlowPoint here = path.at(t);
  double dt = move / glm::length(here.v);
  for (int attempt = 0; attempt < 4; ++attempt) {
    if (!(dt < infinity)) dt = std::numeric_limits<double>::max();
    // Half a step further tells whether a sliver would be left at the end.
    if (!path.reach(t + 1.5 * dt, sampler)) {
      const double left = path.time() - t;
      if (left <= 1e-6 * dt || left <= 0) return std::nullopt;
      if (left < 1.5 * dt) dt = left > dt ? 0.5 * left : left;
    }
    const double moved = glm::distance(path.at(t + dt).x, here.x);
    if (moved <= 1.25 * move) break;
    dt *= std::max(move / moved, 0.1);
  }
  return std::min(t + dt, path.time());
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
