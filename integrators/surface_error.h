#pragma once

#include "integrators/integrate_surface.h"

namespace pellucid {

/// How far a mesh is from the surface it stands for.
struct SurfaceError {
  std::uint64_t samples = 0;
  double mean = 0, rms = 0, max = 0;                       // distance, world units
  double normal_mean_degrees = 0, normal_max_degrees = 0;  // facet normal against the surface's
};

/// Samples the mesh evenly over its triangles and finds each sample's nearest point of the exact
/// surface: a particle is sent from the seed curve again at the tightest tolerance, and s and t are
/// corrected by Gauss-Newton with ∂x/∂s and ∂x/∂t until the distance is smallest. So the field
/// itself is the truth, be it a formula or interpolated samples. The nearest point is the one
/// reached from the mesh's own (s, t): an upper bound where another sheet is closer.
SurfaceError measure_error(const TriangleMesh& mesh, const SurfaceRequest& request,
                           std::uint64_t samples = 2000);

}  // namespace pellucid
