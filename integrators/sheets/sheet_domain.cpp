// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_domain.h"

#include <algorithm>
#include <cmath>

#include "integrators/mesh/facet_normal.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

double around(double x) { return x - std::floor(x); }

/// A column at each end and corner; on a closed curve three at least, so that the way between two
/// of them is not the way around.
std::vector<double> columns_of(const SeedCurve& curve) {
  std::vector<double> columns = curve.corners;
  columns.push_back(0);
  if (curve.closed)
    columns.insert(columns.end(), {1 / 3., 2 / 3.});
  else
    columns.push_back(1);
  std::ranges::sort(columns);
  const auto same = std::ranges::unique(columns, [](double a, double b) { return b - a < 1e-9; });
  columns.erase(same.begin(), same.end());
  return columns;
}

/// Two rows: the particles of the end, and those of the beginning.
void add_strip(SheetDomain& domain, std::span<const double> columns) {
  for (const double y : {0., 1.})
    for (const double s : columns) domain.places.emplace_back(s, y, 0);
  const auto n = std::uint32_t(columns.size());
  for (std::uint32_t i = 0; i + (domain.closed ? 0 : 1) < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    domain.triangles.push_back({i, next, n + next});
    domain.triangles.push_back({i, n + next, n + i});
  }
}

}  // namespace

Vec3 SheetDomain::step_between(const Vec3& from, const Vec3& to) const {
  Vec3 step = to - from;
  if (closed) step.x -= std::round(step.x);
  return step;
}

Vec3 SheetDomain::between(const Vec3& from, const Vec3& to, double part) const {
  Vec3 place = from + part * step_between(from, to);
  if (closed) place.x = around(place.x);
  return place;
}

double SheetDomain::size() const {
  Box3 box;
  for (const Vec3& place : places) box.extend(place);
  const Vec3 sides = box.max - box.min;
  return std::max({sides.x, sides.y, sides.z});
}

SheetDomain streak_domain(const SeedCurve& curve, double duration) {
  SheetDomain domain;
  domain.closed = curve.closed;
  domain.is_square = true;
  domain.corners = curve.corners;
  add_strip(domain, columns_of(curve));
  const auto on_curve = [closed = curve.closed](double s) { return closed ? around(s) : s; };
  domain.release_at = [=](const Vec3& place) {
    return Release{curve.point_at(on_curve(place.x)), duration * place.y};
  };
  domain.change_at = [=](const Vec3& place, const Vec3& step) {
    return Release{step.x * curve.tangent_at(on_curve(place.x)), duration * step.y};
  };
  // On the crease that starts at a corner ∂x/∂s is two vectors.
  domain.normal_at = [=](const Vec3& place, const Vec3& velocity) {
    if (is_corner(curve, place.x)) return Vec3(0);
    return direction_of(facet_sine(Vec3(0), curve.tangent_at(on_curve(place.x)), velocity));
  };
  return domain;
}

SheetDomain time_domain(const SeedSurface& seed, double duration) {
  SheetDomain domain;
  domain.places = seed.places;
  domain.triangles = seed.triangles;
  domain.creased = seed.creased;
  domain.is_square = seed.is_square;
  domain.release_at = [=](const Vec3& place) { return Release{seed.point_at(place), duration}; };
  domain.change_at = [=](const Vec3& place, const Vec3& step) {
    return Release{seed.tangent_at(place, step), 0};
  };
  domain.normal_at = [=](const Vec3& place, const Vec3&) { return seed.normal_at(place); };
  return domain;
}

}  // namespace pellucid::integrators
