// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/trajectory_options.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::integrators {

double positive(const Parameters& parameters, std::string_view name, double otherwise) {
  if (!parameters.is_set(name)) return otherwise;
  const double value = parameters.real(name);
  if (!(value > 0)) throw InputError(fmt::format("{}={}; accepted: number > 0", name, value));
  return value;
}

TrajectoryOptions trajectory_options(const fields::VectorField& field, const Journey& journey,
                                     double extent, const Parameters& parameters) {
  if (!(journey.duration > 0) || !std::isfinite(journey.duration))
    throw InputError(fmt::format("duration: {}; accepted: a finite number > 0", journey.duration));
  if (!std::isfinite(journey.start_time))
    throw InputError(fmt::format("start-time: {}; accepted: a finite number", journey.start_time));
  TrajectoryOptions options;
  options.stepper = &find_row("stepper", parameters.text("stepper"), steppers());
  options.duration = journey.duration;
  options.start_time = journey.start_time;
  options.path = journey.path;
  options.tolerance = positive(parameters, "accuracy", 1e-9 * extent);
  options.max_length = positive(parameters, "length", options.max_length);
  options.max_steps = std::uint64_t(parameters.real("max-steps"));
  options.max_step = positive(
      parameters, "dt", options.stepper->adaptive ? journey.duration : journey.duration / 500);
  // Samples are only piecewise smooth: a step may not jump over a cell.
  const double cells = positive(parameters, "cells", 0.5);
  if (const auto cell = field.cell_size()) options.max_move = cells * *cell;
  options.velocity_error = field.sampling_error().value_or(0);
  if (!parameters.is_set("cells") && field.cell_size() && field.fills_domain())
    options.filled = field.domain();
  options.still = 1e-12 * extent;
  return options;
}

}  // namespace pellucid::integrators
