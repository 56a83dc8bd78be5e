// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of a distance by the parity of crossings with a ray, its size by CGAL's bounding box
// tree. Of CGAL the headers alone are used: doubles need neither its libraries nor -frounding-math.
#include "geometry/solid_mesh.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.h"
#include "geometry/half_edges.h"

namespace pellucid::geometry {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR >= 6
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

Kernel::Point_3 cgal(const Vec3& x) { return {x.x, x.y, x.z}; }

/// In doubles a ray that meets an edge counts both of its triangles or none. Three rays of
/// directions that no mesh is made along do not all: the majority of their parities decides.
constexpr std::array<std::array<double, 3>, 3> directions{
    {{0.5377, 0.6181, 0.5733}, {-0.7071, 0.2113, 0.6747}, {0.1931, -0.8761, -0.4417}}};

void check_closed(const TriangleMesh& mesh) {
  const HalfEdges joined = half_edges(mesh);
  const std::uint64_t open = joined.boundary_edges + joined.non_manifold_edges;
  if (open > 0 || mesh.triangles.empty())
    throw InputError(fmt::format(
        "{} triangles, {} edges of other than two; accepted: a closed mesh with shared vertices",
        mesh.triangles.size(), open));
}

Triangles triangles_of(const TriangleMesh& mesh) {
  check_closed(mesh);
  Triangles triangles;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.emplace_back(cgal(mesh.positions[a]), cgal(mesh.positions[b]),
                           cgal(mesh.positions[c]));
  return triangles;
}

}  // namespace

struct SolidMesh::State {
  Triangles triangles;
  Tree tree;
  Box3 bounds;

  explicit State(const TriangleMesh& mesh)
      : triangles(triangles_of(mesh)),
        tree(triangles.begin(), triangles.end()),
        bounds(mesh.bounds()) {
    tree.build();  // now, since it would be built by the first who asks
  }

  bool inside(const Vec3& x) const {
    if (!bounds.contains(x)) return false;
    int odd = 0;
    for (const auto& [u, v, w] : directions)
      odd += int(
          tree.number_of_intersected_primitives(Kernel::Ray_3(cgal(x), Kernel::Vector_3(u, v, w))) %
          2);
    return odd >= 2;
  }

  bool near(const Vec3& x, double distance) const {
    const Box3 grown{bounds.min - distance, bounds.max + distance};
    return distance > 0 && grown.contains(x) &&
           tree.do_intersect(Kernel::Sphere_3(cgal(x), distance * distance));
  }
};

SolidMesh::SolidMesh(const TriangleMesh& mesh) : state_(std::make_unique<const State>(mesh)) {}
SolidMesh::~SolidMesh() = default;

bool SolidMesh::within(const Vec3& x, double distance) const {
  return state_->near(x, distance) || state_->inside(x);
}

}  // namespace pellucid::geometry
