// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/options/parameters.h"
#include "core/progress.h"
#include "fields/field.h"
#include "geometry/line_set.h"
#include "integrators/paths/end_reason.h"
#include "integrators/paths/seed_curve.h"

namespace pellucid::integrators {

/// Lines that particles draw from these points.
struct LineRequest {
  const fields::VectorField* field = nullptr;
  std::vector<Vec3> seeds;
  double duration = 0;  // not 0; below it the way back in time
  double start_time = 0;
  Progress progress;
  bool both = false;  // |duration| in both directions, one line of both ways
};

/// LineStats are what the lines took: seconds of wall clock, bytes of lines and trajectories, and
/// how many particles ended for which reason.
struct LineStats {
  std::uint64_t particles = 0;
  std::uint64_t evaluations = 0;
  double seconds = 0;
  std::uint64_t bytes = 0;
  EndCounts ends;
};

/// One line per seed, in their order; empty where the seed has no velocity. A streak line some of
/// whose particles are gone is several, which follow each other. The scalars are "t" (since the
/// particle was let go; below 0 on the way back), "time" (the field's) and "speed".
struct IntegratedLines {
  geometry::LineSet lines;
  LineStats stats;
  std::vector<std::uint32_t> seeds;  // of each line: the number of its seed, ascending
};

/// One row of the table of line integrators.
struct LineIntegratorRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  std::span<const ParameterSpec> parameters;
  int (*particles)(const Parameters&);  // lines on a seed curve
  bool runs_along;                      // the field's time does, not only the particles'
  IntegratedLines (*run)(const LineRequest&, const Parameters&);
};

/// stream-lines, path-lines, streak-lines.
std::span<const LineIntegratorRow> line_integrators();

/// `integrator` is "NAME[:key=value,…]". The result is the same to the last bit for any number of
/// threads. Throws InputError.
IntegratedLines integrate_lines(std::string_view integrator, const LineRequest& request);

/// How many particles "NAME[:key=value,…]" puts on a seed curve. Throws InputError.
int line_particles(std::string_view integrator);

/// Throws InputError where `integrator` asks for several particles: seeds that are points have
/// one each.
void check_seeds_are_points(std::string_view integrator);

/// Throws InputError that names `option` where the field stands still on the integrator's lines.
void check_runs_along(std::string_view option, std::string_view integrator);

/// `count` points evenly spaced in s.
std::vector<Vec3> seeds_on(const SeedCurve& curve, int count);
/// The points of a regular grid that fills the box, x fastest; one point along an axis lies in the
/// middle.
std::vector<Vec3> seeds_in(const Box3& box, int nx, int ny, int nz);

}  // namespace pellucid::integrators
