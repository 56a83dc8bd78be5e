// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "geometry/triangle_mesh.h"

namespace pellucid::integrators {

/// A MeshDistance tells how far points of one mesh are from the other one, in world units; mean and
/// rms are over the area.
struct OneSidedDistance {
  double mean = 0, rms = 0, max = 0;
};

/// How far two meshes are apart. What one of them lacks, a hole or a sheet cut short, shows only in
/// the distance of the other one from it.
struct MeshDistance {
  OneSidedDistance from_first;   // of the first mesh's points from the second mesh
  OneSidedDistance from_second;  // the other way round
};

/// At `samples` points spread over the area of each mesh, and at up to as many where triangles err
/// most for the maximum alone (sample_mesh). The maximum is that of the samples: a
/// lower bound of the Hausdorff distance. A mesh without a triangle of some area throws InputError.
MeshDistance mesh_distance(const geometry::TriangleMesh& first,
                           const geometry::TriangleMesh& second, std::uint64_t samples);

/// Returns how far the farthest of the points is from the mesh, in world units; 0 of none. Throws
/// as mesh_distance().
double largest_distance(std::span<const Vec3> points, const geometry::TriangleMesh& mesh);

}  // namespace pellucid::integrators
