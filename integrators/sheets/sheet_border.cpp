// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_border.h"

#include <algorithm>

#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

/// Halvings of the way to the border: by then it is known to some 1e-10 of a side.
constexpr int halvings = 33;

/// How far the sheet is from the straight line between two vertices, at its middle; 0 where that is
/// not there.
double sagitta(SheetParticles& particles, const SheetDomain& domain, const SheetVertex& a,
               const SheetVertex& b) {
  const SheetVertex middle = vertex_at(particles, domain.between(a.place, b.place, 0.5));
  if (!middle.is_there()) return 0;
  return distance_to_segment(middle.particle.x, a.particle.x, b.particle.x);
}

/// Of the corners that are there, or are not, the middle: of a single one its own place.
Vec3 middle_of(const SheetDomain& domain, const BorderFacet& facet, bool there) {
  std::vector<Vec3> places;
  for (const SheetVertex* corner : facet.corners)
    if (corner->is_there() == there) places.push_back(corner->place);
  return places.size() == 1 ? places[0] : domain.between(places[0], places[1], 0.5);
}

}  // namespace

SheetVertex vertex_at(SheetParticles& particles, const Vec3& place) {
  return {place, particles.at(place)};
}

SheetVertex border_between(SheetParticles& particles, const SheetDomain& domain,
                           const SheetVertex& there, const Vec3& lost) {
  SheetVertex last = there;
  Vec3 beyond = lost;
  for (int i = 0; i < halvings; ++i) {
    SheetVertex middle = vertex_at(particles, domain.between(last.place, beyond, 0.5));
    if (middle.is_there())
      last = std::move(middle);
    else
      beyond = middle.place;
  }
  return last;
}

double border_deviation(SheetParticles& particles, const SheetDomain& domain,
                        const BorderFacet& facet) {
  double largest = 0;
  for (std::size_t k = 0; k < facet.left.size(); ++k) {
    const SheetVertex &a = *facet.left[k], &b = *facet.left[(k + 1) % facet.left.size()];
    const bool on_border =
        std::ranges::count(facet.border, &a) + std::ranges::count(facet.border, &b) == 2;
    if (!on_border) largest = std::max(largest, sagitta(particles, domain, a, b));
  }
  const SheetVertex inner = vertex_at(particles, middle_of(domain, facet, true));
  const SheetVertex outer = vertex_at(particles, middle_of(domain, facet, false));
  if (!inner.is_there() || outer.is_there()) return largest;
  const SheetVertex border = border_between(particles, domain, inner, outer.place);
  return std::max(largest, distance_to_segment(border.particle.x, facet.border[0]->particle.x,
                                               facet.border[1]->particle.x));
}

}  // namespace pellucid::integrators
