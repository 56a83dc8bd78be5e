#pragma once

#include <vector>

#include "groundtruth/crossing.h"

namespace pellucid {

/// Sorts as operator< of Crossing orders. Depths that are spread are first dealt into as many
/// buckets as there are crossings, so that each is sorted among few: linear for the layers of a
/// usual ray, n log n at worst. `scratch` is overwritten; its capacity is reused.
void order_crossings(std::vector<Crossing>& crossings, std::vector<Crossing>& scratch);

}  // namespace pellucid
