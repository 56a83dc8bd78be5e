// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/seed_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fields/readers/series_field.h"
#include "fields/reversed_field.h"

namespace pellucid::integrators {
namespace {

/// Who is on the way when a series ends has left it in time, not in space.
std::string times_in_words(const fields::VectorField& field) {
  const auto times = fields::times_of_series(fields::unreversed(field));
  if (!times) return "";
  return fmt::format(", on the way between its times {} and {}", times->first, times->last);
}

std::string accepted_seeds(const fields::VectorField& field) {
  const Box3 domain = field.domain();
  const std::string times = times_in_words(field);
  if (domain.empty() || !std::isfinite(domain.diagonal()))
    return fmt::format("accepted: seeds at which {} has a velocity{}", field.description(), times);
  return fmt::format("accepted: seeds from {} to {} at which {} has a velocity{}",
                     in_words(domain.min), in_words(domain.max), field.description(), times);
}

}  // namespace

Vec3 onto_edge(const Box3& domain, const Vec3& seed) {
  if (domain.empty() || domain.contains(seed)) return seed;
  // A rounded bound is off by up to half an ulp of a float, 2^-24 of itself; so is one that was
  // added up of a rounded origin and as many rounded spacings: by 2^-24 of each, together 2^-23 of
  // the larger one.
  constexpr double rounding = 0x1p-23;
  const Vec3 edge = glm::clamp(seed, domain.min, domain.max);
  for (int axis = 0; axis < 3; ++axis) {
    const double bound = std::max(std::abs(domain.min[axis]), std::abs(domain.max[axis]));
    if (!(std::abs(seed[axis] - edge[axis]) <= rounding * bound)) return seed;
  }
  return edge;
}

bool is_corner(const SeedCurve& curve, double s) {
  constexpr double same = 1e-9;
  const double on_curve = curve.closed ? s - std::floor(s + same) : s;
  const auto next = std::ranges::lower_bound(curve.corners, on_curve - same);
  return next != curve.corners.end() && *next <= on_curve + same;
}

std::string in_words(const Vec3& x) { return fmt::format("({}, {}, {})", x.x, x.y, x.z); }

std::string ended_in_words(const EndCounts& ends, const fields::VectorField& field) {
  const bool lacks = std::any_of(ends.begin(), ends.end(), [](const EndCounts::value_type& end) {
    return is_for_want_of_field(end.first);
  });
  if (lacks) return fmt::format("they ended: {}; {}", in_words(ends), accepted_seeds(field));
  return fmt::format("they ended: {}, in {}", in_words(ends), field.description());
}

}  // namespace pellucid::integrators
