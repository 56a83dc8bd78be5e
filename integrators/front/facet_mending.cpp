// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/facet_mending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/surface_mesh.h"

namespace pellucid::integrators {
namespace {

using geometry::Corners;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

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

/// Works on the half-edge mesh of the builder's triangles, and hands it back when it is through.
class FacetMender {
 public:
  FacetMender(SurfaceBuilder& builder, const FacetBound& bound, const SurfacePoint& point_at)
      : builder_(builder),
        bound_(bound),
        point_at_(point_at),
        smallest_cosine_(std::cos(radians * bound.largest_angle)),
        splits_left_(bound.most_vertices),
        given_vertices_(builder.vertex_count()),
        joined_(geometry::half_edges(builder.positions(), builder.triangles())) {}

  /// Returns how many were trimmed.
  std::size_t mend(std::vector<FaceHandle> facets);

 private:
  // Vertices by their numbers in the builder.
  std::uint32_t number(VertexHandle v) const {
    const auto i = std::size_t(v.idx());
    return i < given_vertices_ ? std::uint32_t(i) : beyond_given_[i - given_vertices_];
  }
  std::uint32_t from(HalfedgeHandle edge) const { return number(mesh_.from_vertex_handle(edge)); }
  std::uint32_t to(HalfedgeHandle edge) const { return number(mesh_.to_vertex_handle(edge)); }
  std::uint32_t apex(HalfedgeHandle edge) const { return to(mesh_.next_halfedge_handle(edge)); }
  HalfedgeHandle opposite(HalfedgeHandle edge) const {
    return mesh_.opposite_halfedge_handle(edge);
  }
  bool is_on_border(HalfedgeHandle edge) const { return mesh_.is_boundary(opposite(edge)); }
  auto sides(FaceHandle facet) const { return geometry::sides(mesh_, facet); }
  Corners corners(FaceHandle facet) const {
    const auto [a, b, c] = sides(facet);
    return {to(c), to(a), to(b)};
  }
  double distance(std::uint32_t a, std::uint32_t b) const {
    return glm::distance(builder_.position(a), builder_.position(b));
  }
  double length(HalfedgeHandle edge) const { return distance(from(edge), to(edge)); }

  bool is_off(FaceHandle facet) const {
    return facet_cosine(builder_, corners(facet)) < smallest_cosine_;
  }
  void push_neighbours(FaceHandle facet, std::vector<FaceHandle>& facets) const;
  double gain(HalfedgeHandle edge, Better better) const;
  bool turn_best(FaceHandle facet, Better better);
  std::vector<FaceHandle> turn_all(std::vector<FaceHandle> off, Better better);
  HalfedgeHandle longest_edge(FaceHandle facet) const;
  double height(HalfedgeHandle edge) const;
  bool can_get_better(HalfedgeHandle edge) const;
  bool leaves_no_area(HalfedgeHandle edge, const Vec3& x) const;
  VertexHandle add_vertex(const FrontPoint& point, double s);
  bool split_longest(FaceHandle facet, std::vector<FaceHandle>& off);
  bool is_narrow(FaceHandle facet) const;
  bool is_removed(FaceHandle facet) const { return trimmed_ > 0 && mesh_.status(facet).deleted(); }
  bool can_remove(FaceHandle facet) const;
  void remove(FaceHandle facet);
  bool trim(FaceHandle facet, std::vector<FaceHandle>& next);
  void trim_all(std::vector<FaceHandle> facets);
  std::vector<FaceHandle> refine(std::vector<FaceHandle> off);
  std::vector<FaceHandle> all_off() const;
  void hand_back();

  SurfaceBuilder& builder_;
  const FacetBound& bound_;
  const SurfacePoint& point_at_;
  double smallest_cosine_;
  std::size_t splits_left_;
  std::size_t given_vertices_;
  geometry::HalfEdges joined_;
  geometry::SurfaceMesh& mesh_ = joined_.mesh;
  // The builder's numbers of the mesh's vertices beyond those: copies, and then new ones.
  std::vector<std::uint32_t>& beyond_given_ = joined_.copied;
  std::size_t trimmed_ = 0;
};

void FacetMender::push_neighbours(FaceHandle facet, std::vector<FaceHandle>& facets) const {
  for (const HalfedgeHandle edge : sides(facet))
    if (!is_on_border(edge)) facets.push_back(mesh_.face_handle(opposite(edge)));
}

/// By how much the edge's two facets get better when it is turned. Turning ends: the sum of all
/// lengths falls; or, since the worse of two facets gets better, the facets' cosines grow in
/// lexicographic order when they are sorted from the worst. In (s, t) the triangulation stays one
/// without folds, whatever its edges do in space.
///
/// An edge and the vertex that split it make a triangle of no area there, or of one by rounding.
/// Turned to, it would bring the edge back, to be split once more in the same place.
double FacetMender::gain(HalfedgeHandle edge, Better better) const {
  constexpr double smallest_share = 1e-6;  // rounding has some 1e-11: doubles near 1, 1e-5 apart
  if (is_on_border(edge)) return 0;
  const std::uint32_t a = from(edge), b = to(edge), c = apex(edge), d = apex(opposite(edge));
  const double left = builder_.parameter_area(c, a, d), right = builder_.parameter_area(d, b, c);
  if (!(std::min(left, right) > smallest_share * (left + right))) return 0;
  if (better == Better::shorter) return distance(a, b) - distance(c, d);
  const auto worse = [&](const Corners& one, const Corners& other) {
    return std::min(facet_cosine(builder_, one), facet_cosine(builder_, other));
  };
  return worse({c, a, d}, {d, b, c}) - worse({a, b, c}, {b, a, d});
}

bool FacetMender::turn_best(FaceHandle facet, Better better) {
  constexpr double smallest_gain = 1e-9;
  const auto edges = sides(facet);
  const double least = better == Better::shorter ? smallest_gain * length(edges[0]) : smallest_gain;
  std::array<double, 3> gains;
  std::ranges::transform(edges, gains.begin(), [&](auto edge) { return gain(edge, better); });
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto best = std::ranges::max_element(gains);
    if (!(*best > least)) return false;
    const auto edge = mesh_.edge_handle(edges[std::size_t(best - gains.begin())]);
    if (mesh_.is_flip_ok(edge)) {
      mesh_.flip(edge);
      return true;
    }
    *best = 0;
  }
  return false;
}

/// Turns edges as long as that helps. Returns the facets that it does not help.
std::vector<FaceHandle> FacetMender::turn_all(std::vector<FaceHandle> off, Better better) {
  std::vector<FaceHandle> stuck;
  while (!off.empty()) {
    const FaceHandle facet = off.back();
    off.pop_back();
    if (!is_off(facet)) continue;
    if (!turn_best(facet, better)) {
      stuck.push_back(facet);
      continue;
    }
    // Its neighbours' other diagonals have changed, so that they may be better off now.
    off.push_back(facet);
    push_neighbours(facet, off);
  }
  return stuck;
}

HalfedgeHandle FacetMender::longest_edge(FaceHandle facet) const {
  const auto edges = sides(facet);
  return *std::ranges::max_element(edges, {}, [&](HalfedgeHandle edge) { return length(edge); });
}

/// Of the facet over its edge.
double FacetMender::height(HalfedgeHandle edge) const {
  const Vec3& start = builder_.position(from(edge));
  const Vec3 side = builder_.position(to(edge)) - start;
  const Vec3 arm = builder_.position(apex(edge)) - start;
  return glm::length(glm::cross(side, arm)) / glm::length(side);
}

/// Would facets be well with edges that are not too short? An edge's sagitta s follows from how far
/// its chord leaves the tangent planes, 4 s; s over the facet's height is the facet's tilt. In a
/// part r of the edge, s falls with r² and the height with r.
bool FacetMender::can_get_better(HalfedgeHandle edge) const {
  const std::uint32_t a = from(edge), b = to(edge);
  const Vec3 chord = builder_.position(b) - builder_.position(a);
  const double sagitta = 0.25 * std::max(std::abs(glm::dot(chord, builder_.normal(a))),
                                         std::abs(glm::dot(chord, builder_.normal(b))));
  const double part = std::tan(radians * bound_.largest_angle) * height(edge) / sagitta;
  return length(edge) * std::min(part, 1.0) > bound_.shortest_edge;
}

/// Would a vertex at x leave the edge's triangles in parts of which one is a line?
bool FacetMender::leaves_no_area(HalfedgeHandle edge, const Vec3& x) const {
  constexpr double smallest_aspect = 1e-6;
  const auto is_line = [&](std::uint32_t end, std::uint32_t third) {
    const Vec3 side = builder_.position(end) - x, arm = builder_.position(third) - x;
    const double longest = std::max({glm::dot(side, side), glm::dot(arm, arm)});
    return glm::length(glm::cross(side, arm)) < smallest_aspect * longest;
  };
  const auto any = [&](HalfedgeHandle each) {
    return is_line(from(each), apex(each)) || is_line(to(each), apex(each));
  };
  return any(edge) || (!is_on_border(edge) && any(opposite(edge)));
}

VertexHandle FacetMender::add_vertex(const FrontPoint& point, double s) {
  beyond_given_.push_back(builder_.add_vertex(point, s));
  const Vec3& x = point.flow.x;
  return mesh_.add_vertex({x.x, x.y, x.z});
}

/// False when that does not help, or the surface has no point there.
bool FacetMender::split_longest(FaceHandle facet, std::vector<FaceHandle>& off) {
  const HalfedgeHandle longest = longest_edge(facet);
  if (!can_get_better(longest) || splits_left_ == 0) return false;
  if (mesh_.n_faces() + 2 > bound_.max_triangles) return false;
  --splits_left_;
  const auto [s, t] = builder_.halfway(from(longest), to(longest));
  const auto point = point_at_(s, t);
  if (!point || leaves_no_area(longest, point->flow.x)) return false;
  for (const FaceHandle part : geometry::split_edge(mesh_, longest, add_vertex(*point, s)))
    if (part.is_valid()) off.push_back(part);
  return true;
}

/// So narrow that nobody misses it.
bool FacetMender::is_narrow(FaceHandle facet) const {
  return height(longest_edge(facet)) <= bound_.shortest_edge;
}

/// Of a facet on the border. Not where two parts would then meet in a vertex alone.
bool FacetMender::can_remove(FaceHandle facet) const {
  int border_edges = 0;
  HalfedgeHandle last;
  for (const HalfedgeHandle edge : sides(facet))
    if (is_on_border(edge)) ++border_edges, last = edge;
  if (border_edges != 1) return border_edges > 1;
  return !mesh_.is_boundary(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(last)));
}

void FacetMender::remove(FaceHandle facet) {
  if (trimmed_++ == 0) {
    mesh_.request_face_status();
    mesh_.request_edge_status();
    mesh_.request_vertex_status();
  }
  mesh_.delete_face(facet);
}

/// Takes a narrow facet off the border; its neighbours may be next.
bool FacetMender::trim(FaceHandle facet, std::vector<FaceHandle>& next) {
  if (is_removed(facet) || !is_narrow(facet) || !can_remove(facet)) return false;
  push_neighbours(facet, next);
  remove(facet);
  return true;
}

/// From the border inwards; a facet behind the border takes one that is on it along.
void FacetMender::trim_all(std::vector<FaceHandle> facets) {
  while (!facets.empty()) {
    const FaceHandle facet = facets.back();
    facets.pop_back();
    if (is_removed(facet) || !is_off(facet) || trim(facet, facets) || !is_narrow(facet)) continue;
    for (const HalfedgeHandle edge : sides(facet))
      if (!is_on_border(edge) && trim(mesh_.face_handle(opposite(edge)), facets)) break;
  }
}

/// Turns and splits. Returns the facets that neither helps.
std::vector<FaceHandle> FacetMender::refine(std::vector<FaceHandle> off) {
  constexpr int most_rounds = 24;  // an edge has been halved away before
  std::vector<FaceHandle> hopeless;
  for (int round = 0; round < most_rounds && !off.empty(); ++round) {
    const auto stuck = turn_all(turn_all(std::move(off), Better::shorter), Better::facing);
    off.clear();
    for (const FaceHandle facet : stuck)
      if (is_off(facet) && !split_longest(facet, off)) hopeless.push_back(facet);
  }
  return hopeless;
}

std::vector<FaceHandle> FacetMender::all_off() const {
  std::vector<FaceHandle> off;
  for (const FaceHandle facet : mesh_.all_faces())
    if (!is_removed(facet) && is_off(facet)) off.push_back(facet);
  return off;
}

void FacetMender::hand_back() {
  auto& triangles = builder_.triangles();
  triangles.clear();
  for (const FaceHandle facet : mesh_.all_faces())
    if (!is_removed(facet)) triangles.push_back(corners(facet));
  if (trimmed_ > 0) builder_.drop_unused_vertices();
}

std::size_t FacetMender::mend(std::vector<FaceHandle> off) {
  constexpr int most_passes = 4;  // trimming opens up ways to turn and split
  for (int pass = 0; pass < most_passes && !off.empty(); ++pass) {
    trim_all(refine(std::move(off)));
    off = all_off();
  }
  hand_back();
  return trimmed_;
}

}  // namespace

std::size_t mend_facets(SurfaceBuilder& builder, const FacetBound& bound,
                        const SurfacePoint& point_at) {
  if (bound.largest_angle >= 180 || !builder.has_normals()) return 0;
  const double smallest_cosine = std::cos(radians * bound.largest_angle);
  std::vector<FaceHandle> off;
  for (std::size_t i = 0; i < builder.triangle_count(); ++i)
    if (facet_cosine(builder, builder.triangles()[i]) < smallest_cosine) off.emplace_back(int(i));
  return off.empty() ? 0 : FacetMender(builder, bound, point_at).mend(std::move(off));
}

}  // namespace pellucid::integrators
