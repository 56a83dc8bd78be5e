// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/triangle_geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "groundtruth/shapes/vertex_blend.h"

namespace pellucid::groundtruth {
namespace {

constexpr int most_slabs = 64;

double half_area(const Box3& box) {
  const Vec3 d = box.max - box.min;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

int longest_axis(const Box3& box) {
  const Vec3 d = box.max - box.min;
  return d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
}

/// Extends the box by the part of the edge (p, q) whose coordinate along the axis lies in [low,
/// high].
void extend_by_clipped(Box3& box, Vec3 p, Vec3 q, int axis, double low, double high) {
  if (p[axis] > q[axis]) std::swap(p, q);
  if (q[axis] < low || p[axis] > high) return;
  const Vec3 edge = q - p;
  if (p[axis] < low) p += (low - p[axis]) / edge[axis] * edge;
  if (q[axis] > high) q -= (q[axis] - high) / edge[axis] * edge;
  box.extend(p);
  box.extend(q);
}

VertexBlend<3> blend_at(const geometry::TriangleMesh& mesh, const Crossing& crossing) {
  // Rounding may leave the first weight an ulp below 0, and the colour outside its hull.
  return {mesh.triangles[crossing.primitive],
          {std::max(0.0, 1 - crossing.u - crossing.v), crossing.u, crossing.v}};
}

/// |n · v| for a two-sided surface, n the normalized interpolation of the vertex normals; a normal
/// without length gives 0.
double facing(const geometry::TriangleMesh& mesh, const VertexBlend<3>& at,
              const Vec3& world_direction) {
  Vec3 n(0);
  for (int i = 0; i < 3; ++i) n += at.weight[i] * mesh.normals[at.vertex[i]];
  const double length = glm::length(n) * glm::length(world_direction);
  return length > 0 ? std::abs(glm::dot(n, world_direction)) / length : 0;
}

}  // namespace

void cross_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t object,
                    std::uint32_t primitive, const RayPacket& packet, std::uint32_t lanes) {
  PacketPredicate::Points at;
  for (std::uint32_t crossed = packet.predicate.crosses(a, b, c, lanes, at); crossed != 0;
       crossed &= crossed - 1) {
    const auto i = std::size_t(std::countr_zero(crossed));
    packet.crossings[i]->push_back({at.depth[i], at.u[i], at.v[i], object, primitive});
  }
}

double size_of(const Vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

TriangleGeometry::TriangleGeometry(const geometry::TriangleMesh& mesh, std::uint32_t index,
                                   const GeometryContext& context, const TriangleGeometry* before)
    : mesh_(mesh), index_(index), frame_(context.frame), lighting_(context.lighting) {
  check_count(mesh.triangles.size(), "triangles");
  positions_.reserve(mesh.positions.size());
  for (const Vec3& x : mesh.positions) {
    positions_.push_back(context.frame.from_world(x));
    largest_ = std::max(largest_, size_of(positions_.back()));
  }
  if (before && before->grouped_triangles() == mesh.triangles.size()) {
    pieces_ = before->pieces_;
    any_slabs_ = before->any_slabs_;
  } else {
    group_triangles();
  }
}

/// Pieces are in the order of their triangles.
std::size_t TriangleGeometry::grouped_triangles() const {
  return pieces_.empty() ? 0 : std::size_t(pieces_.back().first) + pieces_.back().count;
}

/// Triangles that follow each other share a box where all of them together are no wider than a
/// packet of rays, and two also when their box is hardly larger than their own, as in the
/// quadrilaterals of a ribbon: fewer boxes to build and to visit, as many tests.
void TriangleGeometry::group_triangles() {
  constexpr double worth_it = 0.7;  // of the sum of the areas; a quadrilateral has 0.5
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  const auto area = [this](std::uint32_t first, std::uint8_t triangles) {
    return half_area(whole_box({first, triangles, 0, 1}));
  };
  for (std::uint32_t t = 0; t < count;) {
    std::uint8_t group = small_group(t);
    if (group == 1 && t + 1 < count && area(t, 2) < worth_it * (area(t, 1) + area(t + 1, 1)))
      group = 2;
    add_pieces(t, group);
    t += group;
  }
}

/// How many triangles, from the first on, are together no wider than a packet of rays; at least 1.
std::uint8_t TriangleGeometry::small_group(std::uint32_t first) const {
  constexpr std::uint32_t most = 8;
  const std::uint32_t end =
      std::uint32_t(std::min<std::size_t>(mesh_.triangles.size(), first + most));
  Box3 box;
  for (std::uint32_t t = first; t < end; ++t) {
    for (const std::uint32_t v : mesh_.triangles[t]) box.extend(positions_[v]);
    const int axis = longest_axis(box);
    if (box.max[axis] - box.min[axis] > packet_width) return std::uint8_t(std::max(t - first, 1u));
  }
  return std::uint8_t(end - first);
}

/// Halves the slabs as long as that takes away much of what their boxes hold in vain. One as wide
/// as a packet of rays is worth a box of its own.
void TriangleGeometry::add_pieces(std::uint32_t first, std::uint8_t count) {
  constexpr double worth_it = 0.7;  // of the area; a diagonal's halves have 0.5
  Piece piece{first, count, 0, 1};
  const Box3 whole = whole_box(piece);
  const int axis = longest_axis(whole);
  const double length = whole.max[axis] - whole.min[axis];
  double area = half_area(whole);
  while (2 * piece.slabs <= most_slabs && length > 2 * piece.slabs * packet_width) {
    const Piece halved{first, count, 0, std::uint8_t(2 * piece.slabs)};
    const double halved_area = total_area(halved);
    if (halved_area > worth_it * area) break;
    piece = halved;
    area = halved_area;
  }
  any_slabs_ |= piece.slabs > 1;
  for (; piece.slab < piece.slabs; ++piece.slab) pieces_.push_back(piece);
}

double TriangleGeometry::total_area(Piece piece) const {
  double area = 0;
  for (; piece.slab < piece.slabs; ++piece.slab) area += half_area(box(piece));
  return area;
}

Box3 TriangleGeometry::whole_box(const Piece& piece) const {
  Box3 box;
  for (std::uint32_t t = piece.first; t < piece.first + piece.count; ++t)
    for (const std::uint32_t v : mesh_.triangles[t]) box.extend(positions_[v]);
  return box;
}

/// A triangle's part in a slab is spanned by its edges' parts there.
Box3 TriangleGeometry::box(const Piece& piece) const {
  const Box3 whole = whole_box(piece);
  if (piece.slabs == 1) return whole;
  const int axis = longest_axis(whole);
  const double width = (whole.max[axis] - whole.min[axis]) / piece.slabs;
  const double low = whole.min[axis] + piece.slab * width, high = low + width;
  Box3 box;
  for (std::uint32_t t = piece.first; t < piece.first + piece.count; ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      extend_by_clipped(box, positions_[p], positions_[q], axis, low, high);
  }
  return box;
}

std::uint32_t TriangleGeometry::box_count() const {
  return static_cast<std::uint32_t>(pieces_.size());
}

Box3 TriangleGeometry::box(std::uint32_t k) const { return box(pieces_[k]); }

void TriangleGeometry::cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const {
  const Piece& piece = pieces_[k];
  for (std::uint32_t t = piece.first; t < piece.first + piece.count; ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    cross_triangle(positions_[a], positions_[b], positions_[c], index_, t, packet, lanes);
  }
}

double TriangleGeometry::exact_depth(const Crossing& crossing, const PictureRay& ray) const {
  const auto& [a, b, c] = mesh_.triangles[crossing.primitive];
  return plane_depth(frame_, ray,
                     {{mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]},
                      {positions_[a], positions_[b], positions_[c]}});
}

double TriangleGeometry::depth_error(const Crossing& crossing, const SceneRay& ray) const {
  const auto& [a, b, c] = mesh_.triangles[crossing.primitive];
  return groundtruth::depth_error(ray.picture, ray.doubt, ray.predicate.bound(),
                                  {positions_[a], positions_[b], positions_[c]});
}

Fragment TriangleGeometry::shade(const Crossing& crossing, const Vec3& world_direction) const {
  const VertexBlend<3> at = blend_at(mesh_, crossing);
  Fragment fragment = at.fragment(mesh_);
  if (lighting_ != scene::Lighting::none)
    fragment.color = scene::lit(lighting_, fragment.color, facing(mesh_, at, world_direction));
  return fragment;
}

double TriangleGeometry::importance(const Crossing& crossing) const {
  return blend_at(mesh_, crossing).importance(mesh_);
}

std::uint64_t TriangleGeometry::bytes() const {
  return positions_.size() * sizeof(Vec3) + pieces_.size() * sizeof(Piece);
}

}  // namespace pellucid::groundtruth
