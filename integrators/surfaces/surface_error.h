// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// How far a mesh is from the surface it stands for.
struct SurfaceError {
  std::uint64_t samples = 0;                               // those of mean and maximum together
  double mean = 0, rms = 0, max = 0;                       // distance, world units; over the area
  double normal_mean_degrees = 0, normal_max_degrees = 0;  // facet normal against the surface's
  /// The normals of vertices, which light is of, against the surface's at their own (s, t),
  /// whatever their side. Vertices without one, on a crease, or where the surface has none do not
  /// count; nothing where that leaves none.
  std::optional<double> vertex_normal_mean_degrees, vertex_normal_max_degrees;
  /// The other way round: how far points of the surface itself are from the mesh at most, world
  /// units. Large where the mesh stepped over something, or was torn where the surface is not.
  double max_from_surface = 0;
  /// By vertex, for pictures: the largest distance that was found on a triangle around it. Where
  /// not every triangle has a sample, that of the last one before it counts, which lies beside it
  /// in the order in which fronts make them.
  std::vector<double> at_vertices;
};

/// How many samples a user may ask for: their places and distances then take some gigabytes.
constexpr std::uint64_t most_error_samples = 100'000'000;

/// Samples the mesh evenly over its area for mean and rms, and where triangles err most for the
/// maximum (sample_mesh), and finds each sample's nearest point of the exact surface: a particle is
/// sent from the seed curve again at the tightest tolerance, and s and t are corrected by
/// Gauss-Newton with ∂x/∂s and ∂x/∂t until the distance is smallest. So the field itself is the
/// truth, be it a formula or interpolated samples. The nearest point is the one reached from the
/// mesh's own (s, t) or, where that is doubtful and for the largest distances, the nearest of those
/// reached from a dozen vertices around, too: an upper bound still. A few hundred particles of
/// seeds spread over the curve, which know nothing of the mesh's, give the points of
/// `max_from_surface`, wherever the surface has an area. `integrator` holds the mesh's own
/// parameters: particles go no farther than its `length`, and in samples the truth is exacter than
/// its tolerance. The normals are those of `samples` vertices, evenly through the mesh. What the
/// mesh lacks since a budget was used up, as `max-steps`, is missing.
SurfaceError measure_error(const geometry::TriangleMesh& mesh, const SurfaceRequest& request,
                           std::uint64_t samples = 2000, const Parameters& integrator = {});

}  // namespace pellucid::integrators
