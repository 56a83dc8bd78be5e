#include "groundtruth/triangle_geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "groundtruth/vertex_blend.h"

namespace pellucid {
namespace {

double half_area(const Box3& box) {
  const Vec3 d = box.max - box.min;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

VertexBlend<3> blend_at(const TriangleMesh& mesh, const Crossing& crossing) {
  // Rounding may leave the first weight an ulp below 0, and the colour outside its hull.
  return {mesh.triangles[crossing.primitive],
          {std::max(0.0, 1 - crossing.u - crossing.v), crossing.u, crossing.v}};
}

/// |n · v| for a two-sided surface, n the normalized interpolation of the vertex normals; a normal
/// without length gives 0.
double headlight(const TriangleMesh& mesh, const VertexBlend<3>& at, const Vec3& world_direction) {
  Vec3 n(0);
  for (int i = 0; i < 3; ++i) n += at.weight[i] * mesh.normals[at.vertex[i]];
  const double length = glm::length(n) * glm::length(world_direction);
  return length > 0 ? std::abs(glm::dot(n, world_direction)) / length : 0;
}

/// Where the ray with the edge functions `edges`, which crosses the triangle, does so.
Crossing to_crossing(const EdgeFunctions& edges, const Vec3& a, const Vec3& b, const Vec3& c,
                     std::uint32_t object, std::uint32_t primitive) {
  const double sum = edges.e[0] + edges.e[1] + edges.e[2];
  // All zero: the unperturbed ray runs along the triangle; its centre stands for the crossing.
  const double u = sum != 0 ? edges.e[1] / sum : 1.0 / 3, v = sum != 0 ? edges.e[2] / sum : 1.0 / 3;
  return {a.z + u * (b.z - a.z) + v * (c.z - a.z), u, v, object, primitive};
}

}  // namespace

void cross_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t object,
                    std::uint32_t primitive, const SceneRay& ray,
                    std::vector<Crossing>& crossings) {
  EdgeFunctions edges;
  if (ray.test.crosses(a, b, c, edges))
    crossings.push_back(to_crossing(edges, a, b, c, object, primitive));
}

double size_of(const Vec3& x) { return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }

TriangleGeometry::TriangleGeometry(const TriangleMesh& mesh, std::uint32_t index,
                                   const GeometryContext& context)
    : mesh_(mesh), index_(index), lit_(context.lighting != Lighting::none) {
  check_count(mesh.triangles.size(), "triangles");
  positions_.reserve(mesh.positions.size());
  for (const Vec3& x : mesh.positions) {
    positions_.push_back(context.frame.from_world(x));
    largest_ = std::max(largest_, size_of(positions_.back()));
  }
  group_triangles();
}

/// Two triangles that follow each other share a box when it is hardly larger than their own, as in
/// the quadrilaterals of a ribbon: half the boxes to visit, as many tests.
void TriangleGeometry::group_triangles() {
  constexpr double worth_it = 0.7;  // of the sum of the areas; a quadrilateral has 0.5
  const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < count;) {
    groups_.push_back(t);
    const bool pair =
        t + 1 < count && half_area(box_of(t, t + 2)) < worth_it * (half_area(box_of(t, t + 1)) +
                                                                   half_area(box_of(t + 1, t + 2)));
    t += pair ? 2 : 1;
  }
  groups_.push_back(count);
}

Box3 TriangleGeometry::box_of(std::uint32_t first, std::uint32_t last) const {
  Box3 box;
  for (std::uint32_t t = first; t < last; ++t)
    for (const std::uint32_t v : mesh_.triangles[t]) box.extend(positions_[v]);
  return box;
}

std::uint32_t TriangleGeometry::box_count() const {
  return static_cast<std::uint32_t>(groups_.size() - 1);
}

Box3 TriangleGeometry::box(std::uint32_t k) const { return box_of(groups_[k], groups_[k + 1]); }

void TriangleGeometry::cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const {
  std::array<EdgeFunctions, RayPacket::width> edges;
  for (std::uint32_t t = groups_[k]; t < groups_[k + 1]; ++t) {
    const auto& [ia, ib, ic] = mesh_.triangles[t];
    const Vec3 &a = positions_[ia], &b = positions_[ib], &c = positions_[ic];
    for (std::uint32_t crossed = packet.test.crosses(a, b, c, lanes, edges); crossed != 0;
         crossed &= crossed - 1) {
      const int i = std::countr_zero(crossed);
      packet.crossings[i]->push_back(to_crossing(edges[i], a, b, c, index_, t));
    }
  }
}

Fragment TriangleGeometry::shade(const Crossing& crossing, const Vec3& world_direction) const {
  const VertexBlend<3> at = blend_at(mesh_, crossing);
  Fragment fragment = at.fragment(mesh_);
  if (lit_) fragment.color *= headlight(mesh_, at, world_direction);
  return fragment;
}

double TriangleGeometry::importance(const Crossing& crossing) const {
  return blend_at(mesh_, crossing).importance(mesh_);
}

std::uint64_t TriangleGeometry::bytes() const {
  return positions_.size() * sizeof(Vec3) + groups_.size() * sizeof(std::uint32_t);
}

}  // namespace pellucid
