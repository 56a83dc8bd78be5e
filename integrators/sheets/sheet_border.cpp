// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_border.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

/// Halvings of the way to a gap: by then it is known to some 1e-10 of a side.
constexpr int halvings = 33;

double apart(const SheetVertex& a, const SheetVertex& b) {
  return glm::distance(a.particle.x, b.particle.x);
}

/// How far the sheet is from the straight line between two vertices, at its middle; without bound
/// where that is not there.
double sagitta(SheetParticles& particles, const SheetDomain& domain, const SheetVertex& a,
               const SheetVertex& b) {
  const SheetVertex middle = vertex_at(particles, domain.between(a.place, b.place, 0.5));
  if (!middle.is_there()) return std::numeric_limits<double>::infinity();
  return distance_to_segment(middle.particle.x, a.particle.x, b.particle.x);
}

/// Between one that is there and one that is not.
SheetGap border_between(SheetParticles& particles, const SheetDomain& domain,
                        const SheetVertex& from, const SheetVertex& to) {
  const bool forwards = from.is_there();
  SheetVertex last = forwards ? from : to;
  Vec3 beyond = forwards ? to.place : from.place;
  for (int i = 0; i < halvings; ++i) {
    SheetVertex middle = vertex_at(particles, domain.between(last.place, beyond, 0.5));
    if (middle.is_there())
      last = middle;
    else
      beyond = middle.place;
  }
  if (forwards) return {last, std::nullopt};
  return {std::nullopt, last};
}

/// The way between two vertices, and how far apart they are, world units.
struct Way {
  SheetVertex from, to;
  double apart;
};

/// Halves ways, and keeps of the halves those that are longer than `least`, the longest ones first.
/// Empty once none is, or one of their middles is not there.
std::vector<Way> halved(SheetParticles& particles, const SheetDomain& domain,
                        const std::vector<Way>& ways, double least) {
  constexpr std::size_t most = 4;
  std::vector<Way> halves;
  for (const Way& way : ways) {
    const SheetVertex middle =
        vertex_at(particles, domain.between(way.from.place, way.to.place, 0.5));
    if (!middle.is_there()) return {};
    halves.push_back({way.from, middle, apart(way.from, middle)});
    halves.push_back({middle, way.to, apart(middle, way.to)});
  }
  std::erase_if(halves, [&](const Way& way) { return !(way.apart > least); });
  std::ranges::stable_sort(halves, std::greater(), &Way::apart);
  if (halves.size() > most) halves.resize(most);
  return halves;
}

/// Between two that are there. What is smooth gets shorter with each half of the way from some
/// point on, and a jump does not. Both halves are followed while they are long enough: where the
/// flow jumps along its own direction, a smooth half may be as long as the one with the jump.
std::optional<SheetGap> jump_between(SheetParticles& particles, const SheetDomain& domain,
                                     const SheetVertex& from, const SheetVertex& to,
                                     double tolerance) {
  const double whole = apart(from, to);
  const double least = std::max(tolerance, 0.5 * whole);
  std::vector<Way> ways{{from, to, whole}};
  for (int i = 0; i < halvings && !ways.empty(); ++i) ways = halved(particles, domain, ways, least);
  if (ways.empty()) return std::nullopt;
  return SheetGap{ways.front().from, ways.front().to};
}

}  // namespace

SheetVertex vertex_at(SheetParticles& particles, const Vec3& place) {
  return {place, particles.at(place)};
}

std::optional<SheetGap> gap_between(SheetParticles& particles, const SheetDomain& domain,
                                    const SheetVertex& from, const SheetVertex& to,
                                    double tolerance) {
  if (from.is_there() != to.is_there()) return border_between(particles, domain, from, to);
  if (!from.is_there()) return std::nullopt;
  return jump_between(particles, domain, from, to, tolerance);
}

SheetVertex middle_of(SheetParticles& particles, const SheetDomain& domain,
                      const std::vector<const SheetVertex*>& corners) {
  if (corners.size() == 1) return *corners[0];
  return vertex_at(particles, domain.between(corners[0]->place, corners[1]->place, 0.5));
}

double deviation_of(SheetParticles& particles, const SheetDomain& domain, const FacetPart& part,
                    const SheetVertex& across, double tolerance) {
  const double off_sides = std::max(sagitta(particles, domain, *part.first, *part.corners.front()),
                                    sagitta(particles, domain, *part.corners.back(), *part.last));
  const SheetVertex inner = middle_of(particles, domain, part.corners);
  if (!inner.is_there()) return std::numeric_limits<double>::infinity();
  const auto gap = gap_between(particles, domain, inner, across, tolerance);
  if (!gap || !(*gap)[0]) return std::numeric_limits<double>::infinity();
  return std::max(off_sides, distance_to_segment((*gap)[0]->particle.x, part.first->particle.x,
                                                 part.last->particle.x));
}

}  // namespace pellucid::integrators
