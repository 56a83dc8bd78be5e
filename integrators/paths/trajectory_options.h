// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/options/parameters.h"
#include "fields/field.h"
#include "integrators/paths/trajectory.h"

namespace pellucid::integrators {

/// When particles are on their way.
struct Journey {
  double duration = 0;    // > 0
  double start_time = 0;  // the field's time at the seeds
  bool path = false;      // the field's time runs along
};

/// From the stepping parameters. `extent` is the unit of what is relative, in world units. Throws
/// InputError.
TrajectoryOptions trajectory_options(const fields::VectorField& field, const Journey& journey,
                                     double extent, const Parameters& parameters);

/// A number > 0, or what it is when it is not given. Throws InputError.
double positive(const Parameters& parameters, std::string_view name, double otherwise);

}  // namespace pellucid::integrators
