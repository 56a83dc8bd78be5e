// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/options/parameters.h"
#include "core/progress.h"
#include "fields/field.h"
#include "geometry/triangle_mesh.h"
#include "integrators/paths/end_reason.h"
#include "integrators/paths/seed_curve.h"

namespace pellucid::integrators {

/// SurfaceStats are what a surface took.
struct SurfaceStats {
  std::uint64_t particles = 0;    // trajectories started on the seed curve
  std::uint64_t evaluations = 0;  // of the field, with or without its Jacobian, discarded tries too
  double seconds = 0;             // wall clock
  std::uint64_t bytes = 0;        // largest size of the mesh and the trajectories together
  std::uint64_t seed_looks = 0;   // into how many intervals of the seed curve a feature was sought
  std::uint64_t trimmed = 0;      // facets on the border that stood off the surface
  EndCounts ends;                 // how many particles ended for which reason
};

/// A surface to be swept by the particles of a seed curve.
struct SurfaceRequest {
  const fields::VectorField* field = nullptr;
  SeedCurve seed;
  double duration = 0;    // > 0
  double start_time = 0;  // where the field's own time starts
  bool path = false;      // path surface of an unsteady field; otherwise its time stays start_time
  Progress progress;
};

/// The mesh has unit `normals` and the scalars "s" (on the seed curve), "t" (since the seed),
/// "time" (the field's: t + start_time of a path surface, else start_time) and "speed".
struct IntegratedSurface {
  geometry::TriangleMesh mesh;
  SurfaceStats stats;
};

/// IntegratorPromises are what a row of the table promises; a property test holds every row to it.
struct IntegratorPromises {
  bool refines = false;       // neighbours that part get new particles between them
  bool coarsens = false;      // neighbours that meet are merged
  bool bounds_error = false;  // the mesh lies within `tolerance` of the surface
};

/// One row of the table that `trace`, `list`, study files and the tests read.
struct IntegratorRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  std::span<const ParameterSpec> parameters;
  IntegratorPromises promises;
  IntegratedSurface (*run)(const SurfaceRequest&, const Parameters&);
  double default_threshold = 0;  // world units, where neither threshold nor tolerance is given
};

}  // namespace pellucid::integrators
