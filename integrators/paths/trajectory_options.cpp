// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/trajectory_options.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace pellucid::integrators {

double positive(std::string_view name, const std::optional<double>& given, double otherwise) {
  if (!given) return otherwise;
  if (!(*given > 0)) throw InputError(fmt::format("{}={}; accepted: number > 0", name, *given));
  return *given;
}

TrajectoryOptions trajectory_options(const fields::VectorField& field, const Journey& journey,
                                     double extent, const SteppingOptions& stepping) {
  if (!(journey.duration > 0) || !std::isfinite(journey.duration))
    throw InputError(fmt::format("duration: {}; accepted: a finite number > 0", journey.duration));
  if (!std::isfinite(journey.start_time))
    throw InputError(fmt::format("start-time: {}; accepted: a finite number", journey.start_time));
  TrajectoryOptions options;
  options.stepper = stepping.stepper;
  options.duration = journey.duration;
  options.start_time = journey.start_time;
  options.path = journey.path;
  options.tolerance = positive("accuracy", stepping.accuracy, 1e-9 * extent);
  options.max_length = positive("length", stepping.length, options.max_length);
  options.max_steps = stepping.max_steps;
  options.max_step = positive(
      "dt", stepping.dt, options.stepper->adaptive ? journey.duration : journey.duration / 500);
  // Samples are only piecewise smooth: a step may not jump over a cell.
  const double cells = positive("cells", stepping.cells, 0.5);
  if (const auto cell = field.cell_size()) options.max_move = cells * *cell;
  options.velocity_error = field.sampling_error().value_or(0);
  if (!stepping.cells && field.cell_size() && field.fills_domain()) options.filled = field.domain();
  options.still = 1e-12 * extent;
  return options;
}

}  // namespace pellucid::integrators
