// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/facet_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "integrators/mesh/triangle_links.h"

namespace pellucid::integrators {
namespace {

using Corners = TriangleLinks::Triangle;

constexpr double radians = 0.017453292519943295769;

/// Between a facet's normal and that of the corner where it differs most; -1 without an area.
double facet_cosine(const SurfaceBuilder& builder, const Corners& corners) {
  const Vec3& x = builder.position(corners[0]);
  const Vec3 area = glm::cross(builder.position(corners[1]) - x, builder.position(corners[2]) - x);
  const double twice_area = glm::length(area);
  if (!(twice_area > 0)) return -1;
  double smallest = twice_area;
  for (const std::uint32_t corner : corners)
    if (builder.has_one_normal(corner))
      smallest = std::min(smallest, glm::dot(area, builder.normal(corner)));
  return smallest / twice_area;
}

/// Which of two diagonals is the better one: by how much, > 0, when it is the one to be turned to.
enum class Better { shorter, facing };

class FacetMender {
 public:
  FacetMender(SurfaceBuilder& builder, const FacetBound& bound, const SurfacePoint& point_at)
      : builder_(builder),
        bound_(bound),
        point_at_(point_at),
        smallest_cosine_(std::cos(radians * bound.largest_angle)),
        splits_left_(bound.most_vertices),
        links_(builder.triangles(), builder.vertex_count()) {}

  /// Returns how many were trimmed.
  std::size_t mend(std::vector<std::uint32_t> facets);

 private:
  using Edge = TriangleLinks::Edge;

  bool is_off(std::uint32_t facet) const {
    return facet_cosine(builder_, links_.corners(facet)) < smallest_cosine_;
  }
  double gain(const Edge& edge, Better better) const;
  bool turn_best(std::uint32_t facet, Better better);
  Edge longest_edge(std::uint32_t facet) const;
  double height(const Edge& edge) const;
  bool can_get_better(const Edge& edge) const;
  bool leaves_no_area(const Edge& edge, const Vec3& x) const;
  bool split_longest(std::uint32_t facet, std::vector<std::uint32_t>& off);
  bool is_narrow(std::uint32_t facet) const;
  bool trim(std::uint32_t facet, std::vector<std::uint32_t>& next);
  void trim_all(std::vector<std::uint32_t> facets);
  std::vector<std::uint32_t> refine(std::vector<std::uint32_t> off);
  std::vector<std::uint32_t> all_off() const;
  std::vector<std::uint32_t> turn_all(std::vector<std::uint32_t> off, Better better);
  double distance(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(builder_.position(a), builder_.position(b));
  }
  double length(const Edge& edge) const { return distance(links_.from(edge), links_.to(edge)); }

  SurfaceBuilder& builder_;
  const FacetBound& bound_;
  const SurfacePoint& point_at_;
  double smallest_cosine_;
  std::size_t splits_left_;
  TriangleLinks links_;
  std::size_t trimmed_ = 0;
};

/// By how much the edge's two facets get better when it is turned. Turning ends: the sum of all
/// lengths falls; or, since the worse of two facets gets better, the facets' cosines grow in
/// lexicographic order when they are sorted from the worst. In (s, t) the triangulation stays one
/// without folds, whatever its edges do in space.
///
/// An edge and the vertex that split it make a triangle of no area there, or of one by rounding.
/// Turned to, it would bring the edge back, to be split once more in the same place.
double FacetMender::gain(const Edge& edge, Better better) const {
  constexpr double smallest_share = 1e-6;  // rounding has some 1e-11: doubles near 1, 1e-5 apart
  if (links_.neighbour(edge) == TriangleLinks::none) return 0;
  const std::uint32_t a = links_.from(edge), b = links_.to(edge), c = links_.opposite(edge),
                      d = links_.opposite(links_.twin(edge));
  const double left = builder_.parameter_area(c, a, d), right = builder_.parameter_area(d, b, c);
  if (!(std::min(left, right) > smallest_share * (left + right))) return 0;
  if (better == Better::shorter) return distance(a, b) - distance(c, d);
  const auto worse = [&](const Corners& one, const Corners& other) {
    return std::min(facet_cosine(builder_, one), facet_cosine(builder_, other));
  };
  return worse({c, a, d}, {d, b, c}) - worse({a, b, c}, {b, a, d});
}

bool FacetMender::turn_best(std::uint32_t facet, Better better) {
  constexpr double smallest_gain = 1e-9;
  const double least =
      better == Better::shorter ? smallest_gain * length({facet, 0}) : smallest_gain;
  std::array<double, 3> gains;
  for (int k = 0; k < 3; ++k) gains[std::size_t(k)] = gain({facet, k}, better);
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto best = std::max_element(gains.begin(), gains.end());
    if (!(*best > least)) return false;
    const Edge edge{facet, int(best - gains.begin())};
    if (links_.can_turn(edge)) {
      links_.turn(edge);
      return true;
    }
    *best = 0;
  }
  return false;
}

/// Turns edges as long as that helps. Returns the facets that it does not help.
std::vector<std::uint32_t> FacetMender::turn_all(std::vector<std::uint32_t> off, Better better) {
  std::vector<std::uint32_t> stuck;
  while (!off.empty()) {
    const std::uint32_t facet = off.back();
    off.pop_back();
    if (!is_off(facet)) continue;
    if (!turn_best(facet, better)) {
      stuck.push_back(facet);
      continue;
    }
    // Its neighbours' other diagonals have changed, so that they may be better off now.
    off.push_back(facet);
    for (int k = 0; k < 3; ++k)
      if (const auto other = links_.neighbour({facet, k}); other != TriangleLinks::none)
        off.push_back(other);
  }
  return stuck;
}

TriangleLinks::Edge FacetMender::longest_edge(std::uint32_t facet) const {
  Edge longest{facet, 0};
  for (int k = 1; k < 3; ++k)
    if (length({facet, k}) > length(longest)) longest.k = k;
  return longest;
}

/// Of the facet over its edge.
double FacetMender::height(const Edge& edge) const {
  const Vec3& from = builder_.position(links_.from(edge));
  const Vec3 side = builder_.position(links_.to(edge)) - from;
  const Vec3 arm = builder_.position(links_.opposite(edge)) - from;
  return glm::length(glm::cross(side, arm)) / glm::length(side);
}

/// Would facets be well with edges that are not too short? An edge's sagitta s follows from how far
/// its chord leaves the tangent planes, 4 s; s over the facet's height is the facet's tilt. In a
/// part r of the edge, s falls with r² and the height with r.
bool FacetMender::can_get_better(const Edge& edge) const {
  const std::uint32_t a = links_.from(edge), b = links_.to(edge);
  const Vec3 chord = builder_.position(b) - builder_.position(a);
  const double sagitta = 0.25 * std::max(std::abs(glm::dot(chord, builder_.normal(a))),
                                         std::abs(glm::dot(chord, builder_.normal(b))));
  const double part = std::tan(radians * bound_.largest_angle) * height(edge) / sagitta;
  return length(edge) * std::min(part, 1.0) > bound_.shortest_edge;
}

/// Would a vertex at x leave the edge's triangles in parts of which one is a line?
bool FacetMender::leaves_no_area(const Edge& edge, const Vec3& x) const {
  constexpr double smallest_aspect = 1e-6;
  const auto is_line = [&](std::uint32_t end, std::uint32_t apex) {
    const Vec3 side = builder_.position(end) - x, arm = builder_.position(apex) - x;
    const double longest = std::max({glm::dot(side, side), glm::dot(arm, arm)});
    return glm::length(glm::cross(side, arm)) < smallest_aspect * longest;
  };
  const auto any = [&](const Edge& each) {
    const std::uint32_t apex = links_.opposite(each);
    return is_line(links_.from(each), apex) || is_line(links_.to(each), apex);
  };
  return any(edge) || (links_.neighbour(edge) != TriangleLinks::none && any(links_.twin(edge)));
}

/// False when that does not help, or the surface has no point there.
bool FacetMender::split_longest(std::uint32_t facet, std::vector<std::uint32_t>& off) {
  const Edge longest = longest_edge(facet);
  if (!can_get_better(longest) || splits_left_ == 0) return false;
  if (builder_.triangle_count() + 2 > bound_.max_triangles) return false;
  --splits_left_;
  const auto [s, t] = builder_.halfway(links_.from(longest), links_.to(longest));
  const auto point = point_at_(s, t);
  if (!point || leaves_no_area(longest, point->flow.x)) return false;
  for (const std::uint32_t part : links_.split(longest, builder_.add_vertex(*point, s)))
    if (part != TriangleLinks::none) off.push_back(part);
  return true;
}

/// So narrow that nobody misses it.
bool FacetMender::is_narrow(std::uint32_t facet) const {
  return height(longest_edge(facet)) <= bound_.shortest_edge;
}

/// Takes a narrow facet off the border; its neighbours may be next.
bool FacetMender::trim(std::uint32_t facet, std::vector<std::uint32_t>& next) {
  if (links_.is_removed(facet) || !is_narrow(facet) || !links_.can_remove(facet)) return false;
  for (int k = 0; k < 3; ++k)
    if (const auto other = links_.neighbour({facet, k}); other != TriangleLinks::none)
      next.push_back(other);
  links_.remove(facet);
  ++trimmed_;
  return true;
}

/// From the border inwards; a facet behind the border takes one that is on it along.
void FacetMender::trim_all(std::vector<std::uint32_t> facets) {
  while (!facets.empty()) {
    const std::uint32_t facet = facets.back();
    facets.pop_back();
    if (links_.is_removed(facet) || !is_off(facet) || trim(facet, facets)) continue;
    for (int k = 0; k < 3 && is_narrow(facet); ++k)
      if (const auto other = links_.neighbour({facet, k});
          other != TriangleLinks::none && trim(other, facets))
        break;
  }
}

/// Turns and splits. Returns the facets that neither helps.
std::vector<std::uint32_t> FacetMender::refine(std::vector<std::uint32_t> off) {
  constexpr int most_rounds = 24;  // an edge has been halved away before
  std::vector<std::uint32_t> hopeless;
  for (int round = 0; round < most_rounds && !off.empty(); ++round) {
    const auto stuck = turn_all(turn_all(std::move(off), Better::shorter), Better::facing);
    off.clear();
    for (const std::uint32_t facet : stuck)
      if (is_off(facet) && !split_longest(facet, off)) hopeless.push_back(facet);
  }
  return hopeless;
}

std::vector<std::uint32_t> FacetMender::all_off() const {
  std::vector<std::uint32_t> off;
  for (std::uint32_t i = 0; i < builder_.triangle_count(); ++i)
    if (!links_.is_removed(i) && is_off(i)) off.push_back(i);
  return off;
}

std::size_t FacetMender::mend(std::vector<std::uint32_t> off) {
  constexpr int most_passes = 4;  // trimming opens up ways to turn and split
  for (int pass = 0; pass < most_passes && !off.empty(); ++pass) {
    trim_all(refine(std::move(off)));
    off = all_off();
  }
  if (trimmed_ > 0) builder_.drop_unused(TriangleLinks::none);
  return trimmed_;
}

}  // namespace

std::size_t mend_facets(SurfaceBuilder& builder, const FacetBound& bound,
                        const SurfacePoint& point_at) {
  if (bound.largest_angle >= 180 || !builder.has_normals()) return 0;
  const double smallest_cosine = std::cos(radians * bound.largest_angle);
  std::vector<std::uint32_t> off;
  for (std::uint32_t i = 0; i < builder.triangle_count(); ++i)
    if (facet_cosine(builder, builder.triangles()[i]) < smallest_cosine) off.push_back(i);
  return off.empty() ? 0 : FacetMender(builder, bound, point_at).mend(std::move(off));
}

}  // namespace pellucid::integrators
