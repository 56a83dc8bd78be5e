// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
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

/// Says of a sample by its number how far it is off, by a search that is thorough or not.
using Search = std::function<Deviation(std::size_t sample, bool thorough)>;

/// Returns the deviations of `count` samples, in parallel. A search from one place may end where
/// the distance is the smallest around alone: the largest distances are searched for thoroughly,
/// from the largest on, until the largest of all has been.
std::vector<Deviation> search_all(std::size_t count, const Search& search);

/// Returns the mean, rms and maximum of samples' deviations, and the largest distances around the
/// mesh's vertices. `max_from_surface` stays 0.
SurfaceError surface_error(const geometry::TriangleMesh& mesh, std::span<const MeshSample> samples,
                           const std::vector<Deviation>& deviations);

}  // namespace pellucid::integrators
