// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/seeds_extent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {
namespace {

double norm(const Mat3& m) {
  return magnitude({magnitude(m[0]), magnitude(m[1]), magnitude(m[2])});
}

/// |v| / ‖∂v/∂x‖ at x and time t; nothing where that is no length.
std::optional<double> length_of_change(fields::FieldSampler& sampler, const Vec3& x, double t) {
  Vec3 v;
  Mat3 jacobian;
  if (sampler.velocity_and_jacobian(x, t, v, jacobian) != fields::SampleStatus::ok) return {};
  const double length = magnitude(v) / norm(jacobian);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return length;
}

/// At the seed, or where that is uniform or at rest at the nearest of places that it would come to
/// if it went straight on; how far it would go when all is uniform.
double length_along(const LineRequest& request, bool path) {
  constexpr int halvings = 40;  // of the duration: 1e-12 of it
  const Vec3& seed = request.seeds.front();
  const auto sampler = request.field->sampler();
  Vec3 v;
  if (sampler->velocity(seed, request.start_time, v) != fields::SampleStatus::ok) v = Vec3(0);
  const double way = magnitude(v) * request.duration;
  if (way > 0 && std::isfinite(way)) sampler->resolve(way);
  for (int i = halvings + 1; i >= 0; --i) {
    const double t = i > halvings ? 0 : std::ldexp(request.duration, -i);
    const double time = request.start_time + (path ? t : 0);
    if (const auto length = length_of_change(*sampler, seed + t * v, time))
      return way > 0 ? std::min(way, *length) : *length;
  }
  return way > 0 && std::isfinite(way) ? way : 1;
}

}  // namespace

double seeds_extent(const LineRequest& request, bool path) {
  Box3 box;
  for (const Vec3& seed : request.seeds) box.extend(seed);
  if (box.diagonal() > 0) return box.diagonal();
  const double domain = request.field->domain().diagonal();
  return domain > 0 && std::isfinite(domain) ? domain : length_along(request, path);
}

}  // namespace pellucid::integrators
