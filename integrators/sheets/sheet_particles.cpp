// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

double extent_of(const SheetDomain& domain) {
  Box3 box;
  for (const auto& corners : domain.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const double part : {0., 0.5})
        box.extend(domain
                       .release_at(domain.between(domain.places[corners[k]],
                                                  domain.places[corners[(k + 1) % 3]], part))
                       .seed);
  const double extent = box.diagonal();
  if (!(extent > 0) || !std::isfinite(extent))
    throw InputError(fmt::format(
        "seeds: their extent is {}; accepted: finite points that are not all the same", extent));
  return extent;
}

}  // namespace

SheetParticles::SheetParticles(const SheetRequest& request, const SheetDomain& domain,
                               const SteppingOptions& stepping, std::optional<double> tolerance)
    : request_(request),
      domain_(domain),
      field_box_(request.field->domain()),
      extent_(extent_of(domain)),
      options_(trajectory_options(*request.field, {request.duration, request.start_time, true},
                                  extent_, stepping)),
      samplers_(
          [field = request.field, length = extent_] { return CountingSampler(*field, length); }) {
  if (tolerance) bound_errors(options_, *tolerance);
}

/// Of the field where and when the particle is let go; 0 where it has none.
Vec3 SheetParticles::velocity_at(const Release& release) {
  Vec3 v(0);
  samplers_.local().velocity(onto_edge(field_box_, release.seed), end_time() - release.age, v);
  return v;
}

/// The particle's point at the end, with its companion; nothing, and why, when it is not there.
std::optional<FlowPoint> SheetParticles::send(const Release& release, const Vec3& companion,
                                              Companion kind, std::optional<EndReason>& lost) {
  ++sent_;
  TrajectoryOptions options = options_;
  options.companion = kind;
  // Who is let go at the end has no way; a duration has to be one.
  options.duration = std::max(release.age, 1e-15 * request_.duration);
  options.start_time = end_time() - release.age;
  Trajectory path(options, onto_edge(field_box_, release.seed), companion, samplers_.local());
  if (path.exists() && release.age <= 0) return path.at(0);
  if (path.exists()) path.skip_to(options.duration, samplers_.local());
  if (path.exists() && path.end() == EndReason::duration) return path.at(path.time());
  // It stays where it rests, and is there at the end.
  if (path.exists() && path.end() == EndReason::stagnated)
    return path.at_rest(options.duration, samplers_.local());
  lost = path.end().value_or(EndReason::outside);
  return std::nullopt;
}

SheetParticle SheetParticles::at(const Vec3& place) {
  const Release release = domain_.release_at(place);
  SheetParticle particle;
  particle.age = release.age;
  const Vec3 v = velocity_at(release);
  const auto point = send(release, domain_.normal_at(place, v), Companion::conormal, particle.lost);
  if (point) particle.x = point->x, particle.v = point->v, particle.normal = point->w;
  return particle;
}

/// Who is let go dt earlier is v dt farther when the other one is let go.
std::optional<SheetSlope> SheetParticles::slope_at(const Vec3& place,
                                                   const std::array<Vec3, 2>& steps) {
  const Release release = domain_.release_at(place);
  const Vec3 v = velocity_at(release);
  SheetSlope slope;
  std::optional<EndReason> lost;
  for (std::size_t k = 0; k < 2; ++k) {
    const Release change = domain_.change_at(place, steps[k]);
    const auto point = send(release, change.seed + change.age * v, Companion::variation, lost);
    if (!point) return std::nullopt;
    slope.x = point->x;
    slope.along[k] = point->w;
  }
  return slope;
}

std::uint64_t SheetParticles::evaluations() const {
  std::uint64_t count = 0;
  for (const CountingSampler& sampler : samplers_) count += sampler.evaluations();
  return count;
}

}  // namespace pellucid::integrators
