// SPDX-License-Identifier: GPL-3.0-or-later
// The symmetric distance of two meshes, as P. Cignoni, C. Rocchini, R. Scopigno, "Metro: measuring
// error on simplified surfaces", Computer Graphics Forum 17(2), 1998, samples it. Nearest triangles
// come from CGAL's bounding box tree. The room's one file with CGAL, of which it takes the headers
// alone: doubles need neither its libraries nor -frounding-math.
#include "integrators/mesh/mesh_distance.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "integrators/mesh/mesh_samples.h"

namespace pellucid::integrators {
namespace {

// Double is enough: a distance is wanted, not the sign of a predicate.
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

/// Those with a plane; the others are edges of their neighbours.
Triangles triangles_of(const geometry::TriangleMesh& mesh) {
  Triangles triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Kernel::Triangle_3 triangle(cgal(mesh.positions[a]), cgal(mesh.positions[b]),
                                      cgal(mesh.positions[c]));
    if (triangle.squared_area() > 0) triangles.push_back(triangle);
  }
  if (triangles.empty()) throw InputError("mesh distance: a mesh has no triangle with an area");
  return triangles;
}

OneSidedDistance distance_from(const Tree& target, const geometry::TriangleMesh& mesh,
                               std::uint64_t samples) {
  OneSidedDistance distance;
  for (const MeshSample& sample : sample_mesh(mesh, samples)) {
    const double squared = target.squared_distance(cgal(position_of(mesh, sample)));
    distance.mean += sample.weight * std::sqrt(squared);
    distance.rms += sample.weight * squared;
    distance.max = std::max(distance.max, std::sqrt(squared));
  }
  distance.rms = std::sqrt(distance.rms);
  return distance;
}

}  // namespace

MeshDistance mesh_distance(const geometry::TriangleMesh& first,
                           const geometry::TriangleMesh& second, std::uint64_t samples) {
  const Triangles first_triangles = triangles_of(first), second_triangles = triangles_of(second);
  const Tree first_tree(first_triangles.begin(), first_triangles.end());
  const Tree second_tree(second_triangles.begin(), second_triangles.end());
  return {distance_from(second_tree, first, samples), distance_from(first_tree, second, samples)};
}

double largest_distance(std::span<const Vec3> points, const geometry::TriangleMesh& mesh) {
  const Triangles triangles = triangles_of(mesh);
  const Tree tree(triangles.begin(), triangles.end());
  double largest = 0;
  for (const Vec3& x : points) largest = std::max(largest, tree.squared_distance(cgal(x)));
  return std::sqrt(largest);
}

}  // namespace pellucid::integrators
