// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/vec.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::integrators {

/// A SeedSurface is where the particles of a time surface start. Its triangles, in a space of
/// places that need not be the world's, say how it hangs together; a place within one of them is a
/// point of it. A value; made by one of the functions below.
struct SeedSurface {
  std::vector<Vec3> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::function<Vec3(const Vec3& place)> point_at;  // world units
  /// How a point moves per step of its place; world units.
  std::function<Vec3(const Vec3& place, const Vec3& step)> tangent_at;
  std::function<Vec3(const Vec3& place)> normal_at;  // unit, world; 0 where triangles alone tell
  bool creased = false;    // each triangle is a smooth piece of its own, which ends at its sides
  bool is_square = false;  // places are (u, v, 0), u and v in [0, 1]
};

/// Makes the parallelogram corner + a u + b v, a and b in [0, 1]; world units. Throws InputError
/// when its area is 0 or a number is not finite.
SeedSurface patch_seed(const Vec3& corner, const Vec3& u, const Vec3& v);

/// Makes the sphere about `center`; world units. Throws InputError unless the radius is above 0.
SeedSurface sphere_seed(const Vec3& center, double radius);

/// Makes the surface of a mesh's triangles; vertices at one position are one. Throws InputError
/// when none has an area, or a position is not finite.
SeedSurface mesh_seed(const geometry::TriangleMesh& mesh);

}  // namespace pellucid::integrators
