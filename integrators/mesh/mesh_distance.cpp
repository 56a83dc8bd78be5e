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

double largest_coordinate(const geometry::TriangleMesh& mesh) {
  double largest = 0;
  for (const Vec3& x : mesh.positions)
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  return largest;
}

/// Areas have squares, the fourth powers of lengths, which leave a double's range in units of 1e-81
/// or 1e77. A power of two, 1 / unit, changes no digit.
double unit_for(double largest) {
  constexpr int farthest = 1000;
  return largest > 0 ? std::ldexp(1, std::clamp(std::ilogb(largest), -farthest, farthest)) : 1;
}

/// Those with a plane, in a unit; the others are edges of their neighbours.
Triangles triangles_of(const geometry::TriangleMesh& mesh, double unit) {
  Triangles triangles;
  const auto corner = [&](std::uint32_t i) { return cgal(mesh.positions[i] / unit); };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Kernel::Triangle_3 triangle(corner(a), corner(b), corner(c));
    if (triangle.squared_area() > 0) triangles.push_back(triangle);
  }
  if (triangles.empty()) throw InputError("mesh distance: a mesh has no triangle with an area");
  return triangles;
}

/// The tree is in the unit, the distance in world units.
OneSidedDistance distance_from(const Tree& target, const geometry::TriangleMesh& mesh,
                               std::uint64_t samples, double unit) {
  OneSidedDistance distance;
  for (const MeshSample& sample : sample_mesh(mesh, samples)) {
    const double squared = target.squared_distance(cgal(position_of(mesh, sample) / unit));
    distance.mean += sample.weight * std::sqrt(squared);
    distance.rms += sample.weight * squared;
    distance.max = std::max(distance.max, std::sqrt(squared));
  }
  return {distance.mean * unit, std::sqrt(distance.rms) * unit, distance.max * unit};
}

}  // namespace

MeshDistance mesh_distance(const geometry::TriangleMesh& first,
                           const geometry::TriangleMesh& second, std::uint64_t samples) {
  const double unit = unit_for(std::max(largest_coordinate(first), largest_coordinate(second)));
  const Triangles first_triangles = triangles_of(first, unit),
                  second_triangles = triangles_of(second, unit);
  const Tree first_tree(first_triangles.begin(), first_triangles.end());
  const Tree second_tree(second_triangles.begin(), second_triangles.end());
  return {distance_from(second_tree, first, samples, unit),
          distance_from(first_tree, second, samples, unit)};
}

double largest_distance(std::span<const Vec3> points, const geometry::TriangleMesh& mesh) {
  const double unit = unit_for(largest_coordinate(mesh));
  const Triangles triangles = triangles_of(mesh, unit);
  const Tree tree(triangles.begin(), triangles.end());
  double largest = 0;
  for (const Vec3& x : points) largest = std::max(largest, tree.squared_distance(cgal(x / unit)));
  return std::sqrt(largest) * unit;
}

}  // namespace pellucid::integrators
