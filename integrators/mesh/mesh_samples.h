// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace pellucid::integrators {

/// A point of a mesh, and the part of the mesh's area that it stands for: the parts add up to 1.
/// One that stands for none counts for the maximum alone.
struct MeshSample {
  std::size_t triangle;
  std::array<double, 3> barycentric;
  double weight;
};

/// Samples `samples` places evenly over the area, one by lot in each equal part of it, so that sums
/// by their parts come to the integral over the mesh in whatever order its triangles are; and,
/// standing for no area, the middles of triangles and of their sides, where linear interpolation of
/// a curved surface errs most: all four of every triangle where that takes no more than `samples`,
/// else one beside each sample. Ascending in the triangle; the same for the same mesh.
std::vector<MeshSample> sample_mesh(const geometry::TriangleMesh& mesh, std::uint64_t samples);

/// Returns where a sample lies, in world units.
Vec3 position_of(const geometry::TriangleMesh& mesh, const MeshSample& sample);

}  // namespace pellucid::integrators
