// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace pellucid::integrators {

/// A point of a mesh, and the part of the mesh's area that it stands for: the parts add up to 1.
struct MeshSample {
  std::size_t triangle;
  std::array<double, 3> barycentric;
  double weight;
};

/// Samples evenly over the area, or every triangle at four places where that takes no more samples:
/// its middle and those of its sides, where linear interpolation of a curved surface errs most.
/// Ascending in the triangle.
std::vector<MeshSample> sample_mesh(const geometry::TriangleMesh& mesh, std::uint64_t samples);

/// Returns where a sample lies, in world units.
Vec3 position_of(const geometry::TriangleMesh& mesh, const MeshSample& sample);

}  // namespace pellucid::integrators
