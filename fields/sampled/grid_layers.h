// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "fields/sampled/axis.h"

namespace pellucid::fields {

/// GridLayers are the layers of a grid along one axis: where they are, and which of the file's
/// layers each is. Of values in cells there is one layer fewer than positions.
struct GridLayers {
  Axis axis;
  std::vector<std::size_t> source;
};

/// Returns the file's layers as they are: `count` of them.
GridLayers plain_layers(Axis axis, std::size_t count);

/// Returns `count` equal layers, an even number, in place of the only one of a flat grid: evenly
/// spaced by `width` and half of them on each side of it. Of values in cells there is one fewer.
GridLayers extruded_layers(double position, double width, std::size_t count, bool of_cells);

/// Returns the layers of an axis that repeats itself, and one or two more at each end, so that
/// every interpolation finds its samples wherever in one period it is asked. `period` is at least
/// the axis's length: where it is longer, a cell joins the last sample to the first. Values in
/// cells leave no such gap.
GridLayers repeated_layers(const Axis& axis, double period, bool of_cells);

}  // namespace pellucid::fields
