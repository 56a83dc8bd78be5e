// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/facet_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "integrators/front/facet_patches.h"
#include "integrators/front/front_mesh.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

using geometry::Corners;
using Facet = FrontMesh::Facet;
using Edge = FrontMesh::Edge;

constexpr double radians = 0.017453292519943295769;

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
        mesh_(builder),
        patches_(builder, {smallest_cosine_, bound.shortest_edge}) {}

  /// Returns how many were trimmed.
  std::size_t mend(std::vector<Facet> facets);

 private:
  double distance(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(builder_.position(a), builder_.position(b));
  }
  double length(Edge edge) const { return distance(mesh_.from(edge), mesh_.to(edge)); }

  /// Has a triangle no area in space, to rounding? It may have one in (s, t), where particles rest.
  bool is_line(const Corners& corners) const {
    constexpr double smallest_sine = 1e-12;
    const Vec3& x = builder_.position(corners[0]);
    const Vec3 one = direction_of(builder_.position(corners[1]) - x);
    const Vec3 other = direction_of(builder_.position(corners[2]) - x);
    return glm::length(glm::cross(one, other)) < smallest_sine;
  }
  bool is_off(Facet facet) const {
    return facet_cosine(builder_, mesh_.corners(facet)) < smallest_cosine_;
  }
  double gain(Edge edge, Better better) const;
  bool turn_best(Facet facet, Better better);
  std::vector<Facet> turn_all(std::vector<Facet> off, Better better);
  Edge longest_edge(Facet facet) const;
  double height(Edge edge) const;
  bool can_get_better(Edge edge) const;
  bool leaves_no_area(Edge edge, const Vec3& x) const;
  bool is_beside(Edge edge, const Vec3& x) const;
  bool is_back_to_back(Edge edge, const Vec3& normal) const;
  bool is_of_use(Edge edge, const FrontPoint& point) const;
  bool split_longest(Facet facet, std::vector<Facet>& off);
  bool is_narrow(Facet facet) const;
  bool trim(Facet facet, std::vector<Facet>& next);
  void trim_all(std::vector<Facet> facets);
  std::vector<Facet> refine(std::vector<Facet> off);
  std::vector<Facet> all_off() const;
  std::size_t hand_back();

  SurfaceBuilder& builder_;
  const FacetBound& bound_;
  const SurfacePoint& point_at_;
  double smallest_cosine_;
  std::size_t splits_left_;
  FrontMesh mesh_;
  FacetPatches patches_;
  std::vector<std::uint32_t> trimmed_;  // a corner of each
};

/// By how much the edge's two facets get better when it is turned. Turning ends: the sum of all
/// lengths falls; or, since the worse of two facets gets better, the facets' cosines grow in
/// lexicographic order when they are sorted from the worst. In (s, t) the triangulation stays one
/// without folds, whatever its edges do in space. Around a vertex at rest, which has many t, (s, t)
/// tells nothing: there edges stay.
///
/// An edge and the vertex that split it make a triangle of no area there, or of one by rounding.
/// Turned to, it would bring the edge back, to be split once more in the same place.
double FacetMender::gain(Edge edge, Better better) const {
  constexpr double smallest_share = 1e-6;  // rounding has some 1e-11: doubles near 1, 1e-5 apart
  if (mesh_.is_on_border(edge)) return 0;
  const std::uint32_t a = mesh_.from(edge), b = mesh_.to(edge), c = mesh_.apex(edge),
                      d = mesh_.apex(mesh_.opposite(edge));
  if (std::ranges::any_of(std::array{a, b, c, d}, [&](auto v) { return builder_.rests(v); }))
    return 0;
  const double left = builder_.parameter_area(c, a, d), right = builder_.parameter_area(d, b, c);
  if (!(std::min(left, right) > smallest_share * (left + right))) return 0;
  if (is_line({c, a, d}) || is_line({d, b, c})) return 0;
  if (better == Better::shorter) return distance(a, b) - distance(c, d);
  const auto worse = [&](const Corners& one, const Corners& other) {
    return std::min(facet_cosine(builder_, one), facet_cosine(builder_, other));
  };
  return worse({c, a, d}, {d, b, c}) - worse({a, b, c}, {b, a, d});
}

bool FacetMender::turn_best(Facet facet, Better better) {
  constexpr double smallest_gain = 1e-9;
  const auto edges = mesh_.sides(facet);
  const double least = better == Better::shorter ? smallest_gain * length(edges[0]) : smallest_gain;
  std::array<double, 3> gains;
  std::ranges::transform(edges, gains.begin(), [&](auto edge) { return gain(edge, better); });
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto best = std::ranges::max_element(gains);
    if (!(*best > least)) return false;
    const Edge edge = edges[std::size_t(best - gains.begin())];
    const std::array around{
        mesh_.from(edge), mesh_.to(edge), mesh_.apex(edge),
        mesh_.is_on_border(edge) ? mesh_.apex(edge) : mesh_.apex(mesh_.opposite(edge))};
    if (mesh_.turn(edge)) return patches_.join(around), true;
    *best = 0;
  }
  return false;
}

/// Turns edges as long as that helps. Returns the facets that it does not help.
std::vector<Facet> FacetMender::turn_all(std::vector<Facet> off, Better better) {
  std::vector<Facet> stuck;
  while (!off.empty()) {
    const Facet facet = off.back();
    off.pop_back();
    if (!is_off(facet)) continue;
    if (!turn_best(facet, better)) {
      stuck.push_back(facet);
      continue;
    }
    // Its neighbours' other diagonals have changed, so that they may be better off now.
    off.push_back(facet);
    mesh_.push_neighbours(facet, off);
  }
  return stuck;
}

Edge FacetMender::longest_edge(Facet facet) const {
  const auto edges = mesh_.sides(facet);
  return *std::ranges::max_element(edges, {}, [&](Edge edge) { return length(edge); });
}

/// Of the facet over its edge.
double FacetMender::height(Edge edge) const {
  const Vec3& start = builder_.position(mesh_.from(edge));
  const Vec3 side = builder_.position(mesh_.to(edge)) - start;
  const Vec3 arm = builder_.position(mesh_.apex(edge)) - start;
  return glm::length(glm::cross(side, arm)) / glm::length(side);
}

/// Would facets be well with edges that are not too short? An edge's sagitta s over
/// the facet's height is the facet's tilt. In a part r of the edge, s falls with r² and the height
/// with r.
bool FacetMender::can_get_better(Edge edge) const {
  const double sagitta = sagitta_of(builder_, mesh_.from(edge), mesh_.to(edge));
  const double part = std::tan(radians * bound_.largest_angle) * height(edge) / sagitta;
  return length(edge) * std::min(part, 1.0) > bound_.shortest_edge;
}

/// Would a vertex at x leave the edge's triangles in parts of which one is a line?
bool FacetMender::leaves_no_area(Edge edge, const Vec3& x) const {
  constexpr double smallest_aspect = 1e-6;
  const auto is_line = [&](std::uint32_t end, std::uint32_t third) {
    const Vec3 side = builder_.position(end) - x, arm = builder_.position(third) - x;
    const double longest = std::max({glm::dot(side, side), glm::dot(arm, arm)});
    return glm::length(glm::cross(side, arm)) < smallest_aspect * longest;
  };
  const auto any = [&](Edge each) {
    return is_line(mesh_.from(each), mesh_.apex(each)) || is_line(mesh_.to(each), mesh_.apex(each));
  };
  return any(edge) || (!mesh_.is_on_border(edge) && any(mesh_.opposite(edge)));
}

/// Does the surface at x, halfway between the edge's ends in (s, t), lie beside the edge in space,
/// too? Where particles all but rest it need not.
bool FacetMender::is_beside(Edge edge, const Vec3& x) const {
  const Vec3 &a = builder_.position(mesh_.from(edge)), &b = builder_.position(mesh_.to(edge));
  return distance_to_segment(x, a, b) <= 0.25 * glm::distance(a, b);
}

/// Would one of the edge's halves have ends whose normals are more than a right angle apart? Where
/// the surface turns its other side, as through a vortex's axis, one of them always has, however
/// short; where it bends, however much in a coarse mesh, the normal between is between.
bool FacetMender::is_back_to_back(Edge edge, const Vec3& normal) const {
  return glm::dot(normal, builder_.normal(mesh_.from(edge))) < 0 ||
         glm::dot(normal, builder_.normal(mesh_.to(edge))) < 0;
}

bool FacetMender::is_of_use(Edge edge, const FrontPoint& point) const {
  const Vec3& x = point.flow.x;
  return is_beside(edge, x) && !leaves_no_area(edge, x) && !is_back_to_back(edge, point.normal);
}

/// False when that does not help, or the surface has no point there.
bool FacetMender::split_longest(Facet facet, std::vector<Facet>& off) {
  const Edge longest = longest_edge(facet);
  if (!can_get_better(longest) || splits_left_ == 0) return false;
  if (builder_.rests(mesh_.from(longest)) || builder_.rests(mesh_.to(longest))) return false;
  if (mesh_.facet_count() + 2 > bound_.max_triangles) return false;
  --splits_left_;
  const auto [s, t] = builder_.halfway(mesh_.from(longest), mesh_.to(longest));
  const auto point = point_at_(s, t);
  if (!point || !is_of_use(longest, *point)) return false;
  mesh_.split(longest, *point, s, [&](Facet part) {
    patches_.join(mesh_.corners(part));
    off.push_back(part);
  });
  return true;
}

/// So narrow that nobody misses it.
bool FacetMender::is_narrow(Facet facet) const {
  return height(longest_edge(facet)) <= bound_.shortest_edge;
}

/// Takes a narrow facet off the border; its neighbours may be next.
bool FacetMender::trim(Facet facet, std::vector<Facet>& next) {
  if (mesh_.is_removed(facet) || !is_narrow(facet) || !mesh_.can_remove(facet)) return false;
  mesh_.push_neighbours(facet, next);
  const Corners corners = mesh_.corners(facet);
  patches_.join(corners);
  trimmed_.push_back(corners[0]);
  mesh_.remove(facet);
  return true;
}

/// From the border inwards; a facet behind the border takes one that is on it along.
void FacetMender::trim_all(std::vector<Facet> facets) {
  while (!facets.empty()) {
    const Facet facet = facets.back();
    facets.pop_back();
    if (mesh_.is_removed(facet) || !is_off(facet) || trim(facet, facets) || !is_narrow(facet))
      continue;
    for (const Edge edge : mesh_.sides(facet))
      if (!mesh_.is_on_border(edge) && trim(mesh_.neighbour(edge), facets)) break;
  }
}

/// Turns and splits. Returns the facets that neither helps.
std::vector<Facet> FacetMender::refine(std::vector<Facet> off) {
  constexpr int most_rounds = 24;  // an edge has been halved away before
  std::vector<Facet> hopeless;
  for (int round = 0; round < most_rounds && !off.empty(); ++round) {
    const auto stuck = turn_all(turn_all(std::move(off), Better::shorter), Better::facing);
    off.clear();
    for (const Facet facet : stuck)
      if (is_off(facet) && !split_longest(facet, off)) hopeless.push_back(facet);
  }
  return hopeless;
}

std::vector<Facet> FacetMender::all_off() const {
  std::vector<Facet> off;
  for (std::size_t i = 0; i < mesh_.facet_count(); ++i)
    if (const Facet facet{int(i)}; !mesh_.is_removed(facet) && is_off(facet)) off.push_back(facet);
  return off;
}

std::size_t FacetMender::mend(std::vector<Facet> off) {
  constexpr int most_passes = 4;  // trimming opens up ways to turn and split
  for (int pass = 0; pass < most_passes && !off.empty(); ++pass) {
    trim_all(refine(std::move(off)));
    off = all_off();
  }
  return hand_back();
}

/// Gives the builder the facets, in their order, and takes from it vertices that none of them has.
std::size_t FacetMender::hand_back() {
  builder_.triangles() = patches_.better_of(mesh_.facets());
  builder_.drop_unused_vertices();
  return std::size_t(std::ranges::count_if(
      trimmed_, [&](std::uint32_t corner) { return !patches_.is_taken_back(corner); }));
}

}  // namespace

std::size_t mend_facets(SurfaceBuilder& builder, const FacetBound& bound,
                        const SurfacePoint& point_at) {
  if (bound.largest_angle >= 180 || !builder.has_normals()) return 0;
  const double smallest_cosine = std::cos(radians * bound.largest_angle);
  std::vector<Facet> off;
  for (std::size_t i = 0; i < builder.triangle_count(); ++i)
    if (facet_cosine(builder, builder.triangles()[i]) < smallest_cosine) off.emplace_back(int(i));
  return off.empty() ? 0 : FacetMender(builder, bound, point_at).mend(std::move(off));
}

}  // namespace pellucid::integrators
