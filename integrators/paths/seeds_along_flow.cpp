// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/seeds_along_flow.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

enum class Meeting { along, across, nowhere };  // nowhere: one of the two has no direction

Meeting meeting_of(const Vec3& tangent, const Vec3& velocity) {
  constexpr double largest_sine = 1e-9;  // between two directions, each of them rounded
  const Vec3 w = direction_of(tangent), v = direction_of(velocity);
  if (w == Vec3(0) || v == Vec3(0)) return Meeting::nowhere;
  return glm::length(glm::cross(w, v)) > largest_sine ? Meeting::across : Meeting::along;
}

}  // namespace

void check_across_flow(std::string_view integrator, const SeedCurve& seed,
                       const fields::VectorField& field, std::span<const double> times) {
  constexpr int looks = 1000;
  const auto sampler = field.sampler();
  const Box3 domain = field.domain();
  bool is_along = false;
  for (const double time : times)
    for (int i = 0; i < looks; ++i) {
      const double s = (i + 0.5) / looks;
      Vec3 v;
      if (sampler->velocity(onto_edge(domain, seed.point_at(s)), time, v) !=
          fields::SampleStatus::ok)
        continue;
      const Meeting meeting = meeting_of(seed.tangent_at(s), v);
      if (meeting == Meeting::across) return;
      if (meeting == Meeting::along) is_along = true;
    }
  if (is_along)
    throw InputError(
        fmt::format("{}: the seeds run along the flow, and sweep no area; accepted: a "
                    "seed curve that crosses the flow somewhere",
                    integrator));
}

}  // namespace pellucid::integrators
