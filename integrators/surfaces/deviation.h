// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "integrators/mesh/mesh_samples.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid::integrators {

/// A Deviation is how far a mesh's sample is from the surface, world units, and how far the facet's
/// normal there from the surface's, degrees.
struct Deviation {
  double distance = 0, degrees = 0;
};

/// Returns the angle between two unit vectors, degrees.
double degrees_between(const Vec3& a, const Vec3& b);

/// Returns the mean, rms and maximum of samples' deviations, and the largest distances around the
/// mesh's vertices. `max_from_surface` stays 0.
SurfaceError surface_error(const geometry::TriangleMesh& mesh, std::span<const MeshSample> samples,
                           const std::vector<Deviation>& deviations);

}  // namespace pellucid::integrators
