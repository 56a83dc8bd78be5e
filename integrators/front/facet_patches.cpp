// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/facet_patches.h"

#include <algorithm>

namespace pellucid::integrators {

using geometry::Corners;

namespace {

/// Twice the facet's area, in its normal's direction.
Vec3 twice_area_of(const SurfaceBuilder& builder, const Corners& corners) {
  const Vec3& x = builder.position(corners[0]);
  return glm::cross(builder.position(corners[1]) - x, builder.position(corners[2]) - x);
}

/// The same facet, whichever corner comes first.
bool are_same(Corners a, const Corners& b) {
  std::ranges::rotate(a, std::ranges::find(a, b[0]));
  return a == b;
}

}  // namespace

double facet_cosine(const SurfaceBuilder& builder, const Corners& corners) {
  const Vec3 area = twice_area_of(builder, corners);
  const double twice_area = glm::length(area);
  if (!(twice_area > 0)) return -1;
  double smallest = twice_area;
  for (const std::uint32_t corner : corners)
    if (builder.has_one_normal(corner))
      smallest = std::min(smallest, glm::dot(area, builder.normal(corner)));
  return smallest / twice_area;
}

double sagitta_of(const SurfaceBuilder& builder, std::uint32_t a, std::uint32_t b) {
  const Vec3 chord = builder.position(b) - builder.position(a);
  return 0.25 * std::max(std::abs(glm::dot(chord, builder.normal(a))),
                         std::abs(glm::dot(chord, builder.normal(b))));
}

FacetPatches::FacetPatches(const SurfaceBuilder& builder, const FacetMeasure& measure)
    : builder_(builder),
      measure_(measure),
      before_(builder.triangles()),
      sets_(builder.vertex_count()) {}

void FacetPatches::join(std::span<const std::uint32_t> vertices) {
  sets_.grow(builder_.vertex_count());
  for (const std::uint32_t vertex : vertices) sets_.join(vertices[0], vertex);
}

void FacetPatches::add(Standings& standings, const Corners& corners) {
  const double cosine = facet_cosine(builder_, corners);
  const double area = 0.5 * glm::length(twice_area_of(builder_, corners));
  Standing& standing = standings[sets_.find(corners[0])];
  standing.worst = std::min(standing.worst, cosine);
  if (cosine < measure_.smallest_cosine) standing.off += area;
  if (cosine < 0) standing.turned += area;
  for (std::size_t k = 0; k < 3; ++k)
    standing.away = std::max(standing.away, sagitta_of(builder_, corners[k], corners[(k + 1) % 3]));
}

void FacetPatches::compare(const Facets& after) {
  Standings were, are;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool is_new = i >= before_.size();
    if (!is_new && after[i] && are_same(before_[i], *after[i])) continue;
    if (!is_new) add(were, before_[i]);
    if (after[i]) add(are, *after[i]);
  }
  constexpr double rounding = 1e-9;  // of sums and products: a facet in two parts is as it was
  for (const auto& [patch, was] : were) {
    const Standing is = are[patch];
    const bool is_better = is.off < was.off && is.turned <= (1 + rounding) * was.turned &&
                           is.worst >= was.worst - rounding &&
                           is.away <= std::max(was.away, measure_.near_enough);
    taken_back_[patch] = !is_better;
  }
}

bool FacetPatches::is_taken_back(std::uint32_t vertex) {
  const auto found = taken_back_.find(sets_.find(vertex));
  return found != taken_back_.end() && found->second;
}

std::vector<Corners> FacetPatches::better_of(const Facets& after) {
  sets_.grow(builder_.vertex_count());
  compare(after);
  std::vector<Corners> facets;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const bool is_given = i < before_.size();
    if (is_given && is_taken_back(before_[i][0]))
      facets.push_back(before_[i]);
    else if (after[i] && !is_taken_back((*after[i])[0]))
      facets.push_back(*after[i]);
  }
  return facets;
}

}  // namespace pellucid::integrators
