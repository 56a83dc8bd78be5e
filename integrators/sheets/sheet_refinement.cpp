// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "integrators/mesh/facet_normal.h"
#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

/// A quadratic surface is 4/9 of the sum of the sagittas of a facet's sides away from its middle:
/// with 0.7 of the tolerance at each side, 0.94 there.
constexpr double part_of_sides = 0.7;
constexpr double cos_largest_turn = 0.86602540378443865;  // cos 30°

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
      generations_(domain.places.size(), 0),
      facets_(domain.triangles),
      settled_(facets_.size(), false) {
  parallel_for(std::size_t(0), vertices_.size(),
               [&](std::size_t i) { vertices_[i] = vertex_at(particles, domain.places[i]); });
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
  budget_ = exhausted_budget();
  if (budget_) {
    unfinished_ = open;
    return false;
  }
  halve_sides();
  return true;
}

std::optional<EndReason> SheetRefinement::exhausted_budget() const {
  if (facets_.size() >= options_.max_triangles) return EndReason::triangles;
  if (particles_.sent() >= options_.max_particles) return EndReason::particles;
  return std::nullopt;
}

std::uint32_t SheetRefinement::side_of(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax(a, b);
  const auto [found, is_new] =
      numbers_.try_emplace(std::uint64_t(low) << 32 | high, std::uint32_t(sides_.size()));
  if (is_new) sides_.emplace_back().ends = {low, high};
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
    judge(side);
  });
  judged_ = sides_.size();
}

/// In places, of the whole domain.
double SheetRefinement::length_of(const Side& side) const {
  const auto [a, b] = side.ends;
  return glm::length(domain_.step_between(vertices_[a].place, vertices_[b].place)) / size_;
}

void SheetRefinement::judge(Side& side) {
  const SheetVertex &a = vertices_[side.ends[0]], &b = vertices_[side.ends[1]];
  const SheetVertex& middle = side.middle;
  const bool is_there = a.is_there(), goes_on = is_there == middle.is_there();
  // Sides of the first look, of which slanted ones are up to √2 as long as the distance between
  // its particles, are left as they are.
  constexpr double longest = 1.5;
  if (length_of(side) * (options_.particles - 1) > longest)
    side.verdict = Verdict::halve;
  else if (is_there != b.is_there() || (is_there && goes_on && is_uneven(a, b, middle)))
    part_or_halve(side);
  else if (!goes_on || (is_there && deviation(a, b, middle) > part_of_sides * tolerance_))
    halve(side);
}

/// How many halvings have led to the side's ends.
int SheetRefinement::generation_of(const Side& side) const {
  return std::max(generations_[side.ends[0]], generations_[side.ends[1]]);
}

/// Not where the side is short, and not after more halvings than lead there twice: facets that only
/// get thinner, between sides that stay long, would have no end.
void SheetRefinement::halve(Side& side) {
  const double most = 2 * std::log2(1 / options_.rip);
  if (length_of(side) >= options_.rip && generation_of(side) <= most) side.verdict = Verdict::halve;
}

void SheetRefinement::part_or_halve(Side& side) {
  const auto gap = gap_between(particles_, domain_, vertices_[side.ends[0]],
                               vertices_[side.ends[1]], tolerance_);
  if (!gap) return halve(side);
  side.verdict = Verdict::gap;
  side.gap = std::make_unique<SheetGap>(*gap);
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
/// that are sent by, whatever its length.
bool SheetRefinement::is_uneven(const SheetVertex& a, const SheetVertex& b,
                                const SheetVertex& middle) const {
  const Vec3 &from = a.particle.x, &to = b.particle.x;
  const double length = glm::distance(from, to);
  return length > tolerance_ && glm::distance(middle.particle.x, 0.5 * (from + to)) > length / 4;
}

void SheetRefinement::halve_all(const Facet& facet) {
  for (const std::uint32_t i : sides_of(facet)) halve(sides_[i]);
}

/// Facets none of whose sides is to be halved: bent ones, and those across which there is a gap.
void SheetRefinement::judge_facets() {
  std::vector<std::size_t> parted;
  std::vector<Parting> partings;
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    if (settled_[i] || !is_settled(facets_[i])) continue;
    settled_[i] = true;
    if (const auto parting = parting_of(facets_[i])) {
      parted.push_back(i);
      partings.push_back(*parting);
    } else if (gaps_across(facets_[i]) > 0 || is_bent(facets_[i])) {
      halve_all(facets_[i]);
    }
  }
  std::vector<double> deviations(parted.size());
  parallel_for(std::size_t(0), parted.size(), [&](std::size_t k) {
    deviations[k] = gap_deviation(facets_[parted[k]], partings[k]);
  });
  for (std::size_t k = 0; k < parted.size(); ++k)
    if (deviations[k] > part_of_sides * tolerance_) halve_all(facets_[parted[k]]);
}

bool SheetRefinement::is_settled(const Facet& facet) {
  for (const std::uint32_t i : sides_of(facet))
    if (sides_[i].verdict == Verdict::halve) return false;
  return true;
}

/// Narrower than the tolerance it is as flat as it has to be, whichever way it turns: so are facets
/// across a fold, where the sheet turns back.
bool SheetRefinement::is_bent(const Facet& facet) const {
  if (!vertices_[facet[0]].is_there()) return false;  // nor are the others
  const auto x = [&](std::size_t k) { return vertices_[facet[k]].particle.x; };
  const double longest =
      std::max({glm::distance(x(0), x(1)), glm::distance(x(1), x(2)), glm::distance(x(2), x(0))});
  const Vec3 across = facet_sine(x(0), x(1), x(2));
  const double height =
      magnitude(across) * glm::distance(x(1), x(0)) * glm::distance(x(2), x(0)) / longest;
  if (!(height > tolerance_)) return false;
  return std::ranges::any_of(facet, [&, normal = direction_of(across)](std::uint32_t corner) {
    const Vec3 own = direction_of(vertices_[corner].particle.normal);
    return own != Vec3(0) && glm::dot(own, normal) < cos_largest_turn;
  });
}

std::size_t SheetRefinement::gaps_across(const Facet& facet) {
  return std::size_t(std::ranges::count_if(
      sides_of(facet), [&](std::uint32_t i) { return sides_[i].verdict == Verdict::gap; }));
}

/// A gap that goes through the facet crosses two of its sides. One that ends within it crosses one,
/// and where three sheets meet it is three.
std::optional<SheetRefinement::Parting> SheetRefinement::parting_of(const Facet& facet) {
  if (gaps_across(facet) != 2) return std::nullopt;
  const auto sides = sides_of(facet);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t before = sides[(k + 2) % 3], after = sides[k];
    if (sides_[before].verdict == Verdict::gap && sides_[after].verdict == Verdict::gap)
      return Parting{k, {before, after}};
  }
  return std::nullopt;
}

/// The gap's vertex on the side of one of its ends.
const SheetVertex* SheetRefinement::gap_vertex(std::uint32_t side, std::uint32_t beside) const {
  const auto& gap = (*sides_[side].gap)[sides_[side].ends[0] == beside ? 0 : 1];
  return gap ? &*gap : nullptr;
}

std::uint32_t SheetRefinement::number_of_gap_vertex(std::uint32_t side, std::uint32_t beside) {
  auto& number = sides_[side].numbers[sides_[side].ends[0] == beside ? 0 : 1];
  if (!number) {
    number = std::uint32_t(vertices_.size());
    vertices_.push_back(*gap_vertex(side, beside));
  }
  return *number;
}

double SheetRefinement::gap_deviation(const Facet& facet, const Parting& parting) {
  const auto& [apex, sides] = parting;
  const std::uint32_t single = facet[apex], next = facet[(apex + 1) % 3],
                      last = facet[(apex + 2) % 3];
  const FacetPart one{
      {&vertices_[single]}, gap_vertex(sides[0], single), gap_vertex(sides[1], single)};
  const FacetPart other{
      {&vertices_[next], &vertices_[last]}, gap_vertex(sides[1], next), gap_vertex(sides[0], last)};
  const SheetVertex far = middle_of(particles_, domain_, other.corners);
  double largest = 0;
  if (one.first && one.last) largest = deviation_of(particles_, domain_, one, far, tolerance_);
  if (other.first && other.last)
    largest =
        std::max(largest, deviation_of(particles_, domain_, other, vertices_[single], tolerance_));
  return largest;
}

void SheetRefinement::append_sides_of_gap(const Facet& facet, const Parting& parting,
                                          std::vector<Facet>& facets) {
  const auto& [apex, sides] = parting;
  const std::uint32_t single = facet[apex], next = facet[(apex + 1) % 3],
                      last = facet[(apex + 2) % 3];
  if (gap_vertex(sides[0], single) && gap_vertex(sides[1], single))
    facets.push_back(
        {single, number_of_gap_vertex(sides[1], single), number_of_gap_vertex(sides[0], single)});
  if (!gap_vertex(sides[1], next) || !gap_vertex(sides[0], last)) return;
  const std::uint32_t a = number_of_gap_vertex(sides[1], next);
  const std::uint32_t b = number_of_gap_vertex(sides[0], last);
  facets.insert(facets.end(), {{a, next, last}, {a, last, b}});
}

void SheetRefinement::halve_sides() {
  for (Side& side : sides_) {
    if (side.verdict != Verdict::halve || side.halved) continue;
    side.halved = std::uint32_t(vertices_.size());
    vertices_.push_back(side.middle);
    generations_.push_back(generation_of(side) + 1);
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

SheetRefinement::SheetFacets SheetRefinement::facets() {
  SheetFacets sheet;
  for (const Facet& facet : facets_) {
    const std::size_t gaps = gaps_across(facet);
    const bool whole = std::ranges::all_of(
        facet, [&](std::uint32_t corner) { return vertices_[corner].is_there(); });
    if (whole && gaps == 0) sheet.facets.push_back(facet);
    if (whole && gaps > 0) ++sheet.torn;
    if (const auto parting = parting_of(facet)) append_sides_of_gap(facet, *parting, sheet.facets);
  }
  return sheet;
}

std::uint64_t SheetRefinement::bytes() const {
  return vertices_.size() * sizeof(SheetVertex) + facets_.size() * sizeof(Facet) +
         sides_.size() * (sizeof(Side) + 2 * sizeof(std::uint64_t));
}

}  // namespace pellucid::integrators
