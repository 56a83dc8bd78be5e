// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "fields/field.h"
#include "integrators/paths/stepping_options.h"
#include "integrators/paths/trajectory.h"

namespace pellucid::integrators {

/// When particles are on their way.
struct Journey {
  double duration = 0;    // > 0
  double start_time = 0;  // the field's time at the seeds
  bool path = false;      // the field's time runs along
};

/// From the options of stepping. `extent` is the unit of what is relative, in world units. Throws
/// InputError, also of an accuracy for a stepper of fixed steps, and of cells where there are none.
TrajectoryOptions trajectory_options(const fields::VectorField& field, const Journey& journey,
                                     double extent, const SteppingOptions& stepping);

/// Throws InputError where the end of the journey is at a time that a series does not have: of
/// particles that are asked for where they are then, none would be left.
void check_end(const fields::VectorField& field, const Journey& journey);

/// Throws InputError where a surface's tolerance, world units, is given together with a stepper
/// whose steps are fixed: its error is what it is.
void check_keeps_tolerance(const SteppingOptions& stepping, const std::optional<double>& tolerance);

/// Bounds the errors of particles on samples, so that they add up to no more than a thirtieth of
/// `distance`, world units, over the whole duration.
void bound_errors(TrajectoryOptions& options, double distance);

/// Makes the options those of the truth that a mesh is held to, whatever made it: the tightest
/// integration there is. In samples a particle of a mesh that lies within `distance` may err by a
/// thirtieth of it; the truth by a hundredth of what particles err by otherwise. `extent` and
/// `distance` are in world units.
void make_exact(TrajectoryOptions& options, double extent, double distance);

/// A number > 0 that was given as `name`, or what it is when it was not. Throws InputError.
double positive(std::string_view name, const std::optional<double>& given, double otherwise);

}  // namespace pellucid::integrators
