// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "fields/field.h"
#include "fields/files/periods.h"
#include "fields/files/quantity.h"
#include "fields/sampled/dense_field.h"

namespace pellucid::fields {

/// A FileAxis says where a file's samples are along one axis: in grid coordinates, two or more, or
/// one.
struct FileAxis {
  std::optional<Axis> axis;
  double only = 0;  // where there is no axis

  double front() const { return axis ? axis->front() : only; }
  double back() const { return axis ? axis->back() : only; }
};

/// A GridSource is what a file says of a grid along axes, and what was asked of it.
template <class Sample>
struct GridSource {
  std::array<FileAxis, 3> axes;
  SharedSamples<Sample> samples;   // at the points or in the cells (Interpolation::constant)
  std::optional<GridFrame> frame;  // none: the axes are the world's
  Interpolation interpolation = Interpolation::linear;
  Periods periods;
  bool averaged = false;  // samples are means of cells, which are one-sided at the border
  Quantity quantity = Quantity::velocity;
  std::string file;  // for messages
  std::string description;
};

/// Makes a steady field of a grid: of one with a single layer a planar field, of one that repeats
/// itself a periodic one. Where nothing is said of periods, an x axis of even spacing that goes
/// once around in degrees, while y stays within ±90, is a longitude; the description says so. A
/// period without a length is that of the axis where the last layer equals the first (always, of
/// values in cells), else one spacing more, and that of the first of several times or arrays.
/// Throws InputError that names the file for fewer than two samples along two axes, and for periods
/// that do not fit.
template <class Sample>
std::unique_ptr<VectorField> make_grid_field(GridSource<Sample> source);

}  // namespace pellucid::fields
