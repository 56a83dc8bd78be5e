// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/trajectory_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/indexed_random.h"
#include "fields/readers/series_field.h"
#include "fields/reversed_field.h"

namespace pellucid::integrators {

double positive(std::string_view name, const std::optional<double>& given, double otherwise) {
  if (!given) return otherwise;
  if (!(*given > 0)) throw InputError(fmt::format("{}={}; accepted: number > 0", name, *given));
  return *given;
}

namespace {

/// While a particle rests, nothing but this bounds its steps: a flow that sets in for less than a
/// step may be missed between a step's stages. Between the frames of a series nothing is missed,
/// but for those shorter gaps that the series itself does not count.
double default_step(const fields::VectorField& field, const TrajectoryOptions& options) {
  if (!options.stepper->adaptive) return options.duration / 500;
  if (!options.changing) return options.duration;
  return std::min(options.duration / 50, field.time_spacing().value_or(options.duration));
}

/// Where there may be samples; along an axis without an end, of a field that repeats itself, over a
/// thousand cells.
Box3 finite_domain(const fields::VectorField& field) {
  Box3 box = field.domain();
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.max[axis] - box.min[axis]))
      box.min[axis] = 0, box.max[axis] = 1000 * field.cell_size().value_or(1);
  return box;
}

/// A field that is off by something, but whose Jacobian is 0 wherever it is asked for, is constant
/// in each cell. (Another one that is at so many places would lose no more than time.)
bool is_constant_in_cells(const fields::VectorField& field, double time) {
  constexpr std::uint64_t looks = 256;
  const auto sampler = field.sampler();
  const Box3 box = finite_domain(field);
  bool found = false;
  for (std::uint64_t i = 0; i < looks; ++i) {
    Vec3 v;
    Mat3 jacobian;
    const Vec3 x = IndexedRandom(0, i).in_box(0, box);
    if (sampler->velocity_and_jacobian(x, time, v, jacobian) != fields::SampleStatus::ok) continue;
    if (jacobian != Mat3(0)) return false;
    found = true;
  }
  return found;
}

/// The first estimate looks at samples all over the field: it is asked for where it is needed.
/// Who gives particles a companion by the variational equation asks for it, too.
bool needs_sampling_error(const TrajectoryOptions& options, const SteppingOptions& stepping) {
  return options.filled || (options.stepper->adaptive && !stepping.accuracy);
}

void check(const fields::VectorField& field, const Journey& journey) {
  if (!(journey.duration > 0) || !std::isfinite(journey.duration))
    throw InputError(
        fmt::format("duration: {}; accepted: a finite number that is not 0", journey.duration));
  if (!std::isfinite(journey.start_time))
    throw InputError(fmt::format("start-time: {}; accepted: a finite number", journey.start_time));
  const auto times = fields::times_of_series(fields::unreversed(field));
  if (times && !times->contains(journey.start_time))
    throw InputError(fmt::format("start-time: {}; accepted: one of the times of {}",
                                 journey.start_time, field.description()));
}

/// Options that would change nothing are refused: whoever gives them expects something of them.
void check(const fields::VectorField& field, const SteppingOptions& stepping) {
  const std::string_view stepper = stepping.stepper->name;
  if (stepping.accuracy && !stepping.stepper->adaptive)
    throw InputError(
        fmt::format("accuracy={} and stepper={}, whose steps are all of one length; "
                    "accepted: accuracy with {}, dt with {}",
                    *stepping.accuracy, stepper, dopri5().name, stepper));
  if (stepping.cells && !field.cell_size())
    throw InputError(fmt::format("cells={}: {} has no samples; accepted: dt", *stepping.cells,
                                 field.description()));
}

/// What the interpolant is off by anyway bounds the default alone: who gives an accuracy gets it.
/// Where cells are constant it bounds nothing: a field that jumps from cell to cell is off by about
/// as much as it is large, though within a cell the way is exact at no cost, and at a face that is
/// found.
double default_error_floor(const fields::VectorField& field, double velocity_error, double time) {
  if (velocity_error == 0 || is_constant_in_cells(field, time)) return 0;
  return 0.1 * velocity_error;
}

}  // namespace

TrajectoryOptions trajectory_options(const fields::VectorField& field, const Journey& journey,
                                     double extent, const SteppingOptions& stepping) {
  check(field, journey);
  check(field, stepping);
  TrajectoryOptions options;
  options.stepper = stepping.stepper;
  options.duration = journey.duration;
  options.start_time = journey.start_time;
  options.path = journey.path;
  options.tolerance = positive("accuracy", stepping.accuracy, 1e-9 * extent);
  options.max_length = positive("length", stepping.length, options.max_length);
  options.max_steps = stepping.max_steps;
  options.changing = journey.path && !field.steady();
  options.max_step = positive("dt", stepping.dt, default_step(field, options));
  // Samples are only piecewise smooth: a step may not jump over a cell.
  const double cells = positive("cells", stepping.cells, 0.5);
  if (const auto cell = field.cell_size()) options.max_move = cells * *cell;
  if (!stepping.cells && field.cell_size() && field.fills_domain()) options.filled = field.domain();
  if (needs_sampling_error(options, stepping))
    options.velocity_error = field.sampling_error().value_or(0);
  if (!stepping.accuracy)
    options.error_floor = default_error_floor(field, options.velocity_error, journey.start_time);
  options.still = 1e-12 * extent;
  return options;
}

void check_end(const fields::VectorField& field, const Journey& journey) {
  const auto times = fields::times_of_series(fields::unreversed(field));
  const double sign = fields::start_of_reversed(field) ? -1 : 1;
  const double end = journey.start_time + sign * journey.duration;
  if (times && !times->contains(end))
    throw InputError(
        fmt::format("duration: {}, which ends at the time {} when particles are looked for; "
                    "accepted: an end between the times {} and {} of {}",
                    sign * journey.duration, end, times->first, times->last, field.description()));
}

void check_keeps_tolerance(const SteppingOptions& stepping,
                           const std::optional<double>& tolerance) {
  if (tolerance && !stepping.stepper->adaptive)
    throw InputError(
        fmt::format("tolerance={} and stepper={}, whose steps keep no tolerance; "
                    "accepted: tolerance with {}",
                    *tolerance, stepping.stepper->name, dopri5().name));
}

void bound_errors(TrajectoryOptions& options, double distance) {
  constexpr double part = 0.03;
  options.error_floor = std::min(options.error_floor, part * distance / options.duration);
}

void make_exact(TrajectoryOptions& options, double extent, double distance) {
  // Particles of a given accuracy have no floor. In samples the truth has one all the same, that of
  // the bound: down to 1e-13 steps would end at all their kinks, for a hundred times the work.
  const bool is_sampled = std::isfinite(options.max_move);
  options.error_floor = options.error_floor > 0 || !is_sampled
                            ? 0.01 * options.error_floor
                            : std::numeric_limits<double>::infinity();
  bound_errors(options, std::min(0.1 * distance, 1e-4 * extent));
  // A thousand kinks may be as far off as that allows; one by one they would take most of the time.
  options.tolerance = std::max(1e-13 * extent, 1e-3 * options.error_floor * options.duration);
}

}  // namespace pellucid::integrators
