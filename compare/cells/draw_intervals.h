// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "compare/pictures/picture_pair.h"
#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// Returns where each metric of the float pictures lies by the pictures that a method of random
/// numbers drew, the measurement's image and its draws: median_interval() of their values, by the
/// metric's name. Empty where there are no draws. `measured.row.metrics` holds the image's.
std::map<std::string, Interval> intervals_over_draws(const Image& reference,
                                                     const CellMeasurement& measured,
                                                     const PairRegions& regions);

}  // namespace pellucid::compare
