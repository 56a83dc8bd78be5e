// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/marched_isosurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucid::groundtruth {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The ray's parameter where it enters the ball: 0 where it starts within, `never` if it does not.
double entry(const scene::Isosurface::Ball& ball, const WorldRay& ray) {
  const Vec3 to_start = ray.start - ball.center;
  const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(to_start, ray.direction),
               c = glm::dot(to_start, to_start) - ball.radius * ball.radius;
  if (c <= 0) return 0;
  const double discriminant = b * b - a * c;
  return b < 0 && discriminant >= 0 ? (-b - std::sqrt(discriminant)) / a : never;
}

}  // namespace

MarchedIsosurface::MarchedIsosurface(const scene::Isosurface& surface, bool opaque,
                                     std::uint32_t index, const GeometryContext& context,
                                     const MarchOptions& options)
    : IsosurfaceGeometry(surface, index, context),
      march_(*surface.field, surface.value, options),
      opaque_(opaque),
      stop_below_(context.stop_below),
      stops_(context.stops) {}

void MarchedIsosurface::cross(std::uint32_t k, const SceneRay& ray,
                              std::vector<Crossing>& crossings) const {
  const WorldRay world = to_world(ray);
  double shows = 1, end = never;
  for (const scene::Isosurface::Ball& ball : stops_) end = std::min(end, entry(ball, world));
  march_.visit_crossings(world, [&](double t) {
    if (t >= end) return false;
    if (const auto opacity = append(ray, world, t, k, crossings))
      shows *= opaque_ ? 0 : 1 - double(*opacity);
    return shows > 0 && shows >= stop_below_;
  });
}

}  // namespace pellucid::groundtruth
