// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// The flow past a sphere (the fields sphere and shed-wake) at the samples of nested levels, the
/// finest around the sphere, each coarser one twice as coarse.
const DatasetRow& sphere_levels_dataset();

}  // namespace pellucid::scene
