// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

/// A quadratic surface is 4/9 of the sum of the sagittas of a facet's sides away from its middle:
/// with 0.7 of the tolerance at each side, 0.94 there.
constexpr double part_of_sides = 0.7;
constexpr double largest_turn = 0.86602540378443865;  // cos 30°

}  // namespace

SheetRefinement::SheetRefinement(SheetParticles& particles, const SheetDomain& domain,
                                 const SheetOptions& options, double tolerance,
                                 const Progress& progress)
    : particles_(particles),
      domain_(domain),
      options_(options),
      progress_(progress),
      tolerance_(tolerance),
      size_(domain.size()),
      vertices_(domain.places.size()),
      facets_(domain.triangles),
      settled_(facets_.size(), false) {
  parallel_for(std::size_t(0), vertices_.size(),
               [&](std::size_t i) { vertices_[i] = vertex_at(particles, domain.places[i]); });
  sent_ = vertices_.size();
}

void SheetRefinement::run() {
  for (int passes = 1; pass(); ++passes) report(progress_, 1 - std::pow(0.8, passes), "sheet");
}

/// False when no side was halved.
bool SheetRefinement::pass() {
  judge_new_sides();
  judge_facets();
  const auto open = std::size_t(std::ranges::count_if(
      sides_, [](const Side& side) { return side.verdict == Verdict::halve && !side.halved; }));
  if (open == 0) return false;
  if (!is_within_budget()) {
    unfinished_ = open;
    return false;
  }
  halve_sides();
  return true;
}

bool SheetRefinement::is_within_budget() {
  if (sent_ >= options_.max_particles) budget_ = EndReason::particles;
  if (facets_.size() >= options_.max_triangles) budget_ = EndReason::triangles;
  return !budget_;
}

std::uint32_t SheetRefinement::side_of(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  const auto [found, is_new] =
      numbers_.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(sides_.size()));
  if (is_new) sides_.push_back({{low, high}, {}, Verdict::fine, std::nullopt, std::nullopt});
  return found->second;
}

std::array<std::uint32_t, 3> SheetRefinement::sides_of(const Facet& facet) {
  return {side_of(facet[0], facet[1]), side_of(facet[1], facet[2]), side_of(facet[2], facet[0])};
}

void SheetRefinement::judge_new_sides() {
  for (std::size_t i = 0; i < facets_.size(); ++i)
    if (!settled_[i]) sides_of(facets_[i]);
  parallel_for(judged_, sides_.size(), [&](std::size_t i) {
    Side& side = sides_[i];
    const auto [a, b] = side.ends;
    side.middle =
        vertex_at(particles_, domain_.between(vertices_[a].place, vertices_[b].place, 0.5));
    side.verdict = judge(side);
  });
  sent_ += sides_.size() - judged_;
  for (; judged_ < sides_.size(); ++judged_) torn_ += sides_[judged_].verdict == Verdict::tear;
}

/// In places, of the whole domain.
double SheetRefinement::length_of(const Side& side) const {
  const auto [a, b] = side.ends;
  return glm::length(domain_.step_between(vertices_[a].place, vertices_[b].place)) / size_;
}

SheetRefinement::Verdict SheetRefinement::judge(const Side& side) const {
  const double length = length_of(side);
  if (length * (options_.particles - 1) > 1.5) return Verdict::halve;
  const SheetVertex &a = vertices_[side.ends[0]], &b = vertices_[side.ends[1]];
  const bool is_short = length < options_.rip;
  if (a.is_there() != b.is_there()) return Verdict::border;
  if (!a.is_there()) return side.middle.is_there() && !is_short ? Verdict::halve : Verdict::fine;
  if (!side.middle.is_there()) return is_short ? Verdict::tear : Verdict::halve;
  const bool is_straight = deviation(a, b, side.middle) <= part_of_sides * tolerance_;
  if (is_straight && is_even(a, b, side.middle)) return Verdict::fine;
  return is_short ? Verdict::tear : Verdict::halve;
}

/// How far the sheet is from the straight side, world units: at the middle itself, and at the
/// quarters of the cubic curve between both ends that lies in the planes of their normals, which
/// tells where the sheet turns one way and then the other.
double SheetRefinement::deviation(const SheetVertex& a, const SheetVertex& b,
                                  const SheetVertex& middle) const {
  const Vec3 &from = a.particle.x, &to = b.particle.x;
  const double at_middle = distance_to_segment(middle.particle.x, from, to);
  const Vec3 n = direction_of(a.particle.normal), m = direction_of(b.particle.normal);
  if (n == Vec3(0) || m == Vec3(0)) return at_middle;
  const double rise = -glm::dot(n, to - from), fall = -glm::dot(m, to - from);
  return std::max(
      {at_middle, std::abs(9 * rise - 3 * fall) / 64, std::abs(3 * rise - 9 * fall) / 64});
}

/// Of a sheet that is smooth at this scale the side's middle comes to lie near the middle between
/// its ends. Where it does not there may be a jump, across which a straight side passes all points
/// that are sent by whatever its length.
bool SheetRefinement::is_even(const SheetVertex& a, const SheetVertex& b,
                              const SheetVertex& middle) const {
  const Vec3 &from = a.particle.x, &to = b.particle.x;
  const double length = glm::distance(from, to);
  return length <= tolerance_ || glm::distance(middle.particle.x, 0.5 * (from + to)) <= length / 4;
}

std::size_t SheetRefinement::corners_there(const Facet& facet) const {
  return std::size_t(std::ranges::count_if(
      facet, [&](std::uint32_t corner) { return vertices_[corner].is_there(); }));
}

void SheetRefinement::halve_all(const Facet& facet) {
  for (const std::uint32_t i : sides_of(facet))
    if (length_of(sides_[i]) >= options_.rip) sides_[i].verdict = Verdict::halve;
}

/// Facets none of whose sides is to be halved: bent ones, and those on the border of what is there.
void SheetRefinement::judge_facets() {
  std::vector<std::size_t> on_border;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    if (settled_[i] || !is_settled(facets_[i])) continue;
    settled_[i] = true;
    const std::size_t there = corners_there(facets_[i]);
    if (there == 3 && is_bent(facets_[i])) halve_all(facets_[i]);
    if (there == 1 || there == 2) on_border.push_back(i);
  }
  find_borders(on_border);
  std::vector<double> deviations(on_border.size());
  std::vector<BorderFacet> parts;
  for (const std::size_t i : on_border) parts.push_back(border_facet(facets_[i]));
  parallel_for(std::size_t(0), parts.size(), [&](std::size_t k) {
    deviations[k] = border_deviation(particles_, domain_, parts[k]);
  });
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (deviations[k] > part_of_sides * tolerance_) halve_all(facets_[on_border[k]]);
}

bool SheetRefinement::is_settled(const Facet& facet) {
  for (const std::uint32_t i : sides_of(facet))
    if (sides_[i].verdict == Verdict::halve) return false;
  return true;
}

/// Narrower than the tolerance it is as flat as it has to be, whichever way it turns: so are facets
/// across a fold, where the sheet turns back.
bool SheetRefinement::is_bent(const Facet& facet) const {
  const auto x = [&](std::size_t k) { return vertices_[facet[k]].particle.x; };
  const double longest =
      std::max({glm::distance(x(0), x(1)), glm::distance(x(1), x(2)), glm::distance(x(2), x(0))});
  const Vec3 across = glm::cross(direction_of(x(1) - x(0)), direction_of(x(2) - x(0)));
  const double height =
      magnitude(across) * glm::distance(x(1), x(0)) * glm::distance(x(2), x(0)) / longest;
  if (!(height > tolerance_)) return false;
  return std::ranges::any_of(facet, [&, normal = direction_of(across)](std::uint32_t corner) {
    const Vec3 own = direction_of(vertices_[corner].particle.normal);
    return own != Vec3(0) && glm::dot(own, normal) < largest_turn;
  });
}

void SheetRefinement::find_borders(const std::vector<std::size_t>& facets) {
  std::vector<std::uint32_t> sides;
  for (const std::size_t i : facets)
    for (const std::uint32_t side : sides_of(facets_[i]))
      if (sides_[side].verdict == Verdict::border && !sides_[side].border) {
        sides_[side].border = std::uint32_t(vertices_.size() + sides.size());
        sides.push_back(side);
      }
  std::vector<SheetVertex> borders(sides.size());
  parallel_for(std::size_t(0), sides.size(), [&](std::size_t k) {
    const auto [a, b] = sides_[sides[k]].ends;
    const bool first = vertices_[a].is_there();
    borders[k] = border_between(particles_, domain_, vertices_[first ? a : b],
                                vertices_[first ? b : a].place);
  });
  vertices_.insert(vertices_.end(), borders.begin(), borders.end());
}

BorderFacet SheetRefinement::border_facet(const Facet& facet) {
  BorderFacet part;
  std::size_t found = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const SheetVertex& corner = vertices_[facet[k]];
    part.corners[k] = &corner;
    if (corner.is_there()) part.left.push_back(&corner);
    const auto [a, b] = side(facet, k);
    if (const auto border = sides_[side_of(a, b)].border)
      part.left.push_back(part.border[found++] = &vertices_[*border]);
  }
  return part;
}

void SheetRefinement::halve_sides() {
  for (Side& side : sides_) {
    if (side.verdict != Verdict::halve || side.halved) continue;
    side.halved = std::uint32_t(vertices_.size());
    vertices_.push_back(side.middle);
  }
  const auto is_shorter = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto x = [&](std::uint32_t i) { return vertices_[i].particle.x; };
    return glm::distance(x(a), x(b)) < glm::distance(x(c), x(d));
  };
  std::vector<Facet> parts;
  std::vector<bool> settled;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const auto sides = sides_of(facets_[i]);
    const std::array middles{sides_[sides[0]].halved, sides_[sides[1]].halved,
                             sides_[sides[2]].halved};
    const bool stays = std::ranges::none_of(middles, [](const auto& m) { return m.has_value(); });
    if (stays)
      parts.push_back(facets_[i]);
    else
      append_parts(facets_[i], middles, is_shorter, parts);
    settled.resize(parts.size(), stays && settled_[i]);
  }
  facets_ = std::move(parts);
  settled_ = std::move(settled);
}

std::vector<Facet> SheetRefinement::facets() {
  std::vector<Facet> facets;
  for (const Facet& facet : facets_) {
    const auto sides = sides_of(facet);
    if (std::ranges::any_of(sides,
                            [&](std::uint32_t i) { return sides_[i].verdict == Verdict::tear; }))
      continue;
    if (corners_there(facet) == 3) {
      facets.push_back(facet);
      continue;
    }
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < 3; ++k) {
      if (vertices_[facet[k]].is_there()) left.push_back(facet[k]);
      if (const auto border = sides_[sides[k]].border) left.push_back(*border);
    }
    for (std::size_t k = 2; k < left.size(); ++k) facets.push_back({left[0], left[k - 1], left[k]});
  }
  return facets;
}

std::uint64_t SheetRefinement::bytes() const {
  return vertices_.size() * sizeof(SheetVertex) + facets_.size() * sizeof(Facet) +
         sides_.size() * (sizeof(Side) + 2 * sizeof(std::uint64_t));
}

}  // namespace pellucid::integrators
