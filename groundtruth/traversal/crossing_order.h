// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// Sorts crossings as operator< of Crossing orders. Depths that are spread are first dealt into as
/// many buckets as there are crossings, so that each is sorted among few: linear for the layers of
/// a usual ray, n log n at worst.
void order_crossings(std::span<Crossing> crossings);

}  // namespace pellucid::groundtruth
