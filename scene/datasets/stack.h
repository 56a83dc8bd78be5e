// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// Square sheets above one another, for the extremes of a method's numbers: from an orthographic
/// camera that looks along -z, every pixel is crossed by every sheet, and its exact colour is a sum
/// that is known (Baeza Rojo et al. 2019, Eq. 12).
const DatasetRow& stack_dataset();

/// Colour and opacity of the i-th sheet from the front: hues that no two neighbours share.
Rgba stack_color(int i, double alpha);

}  // namespace pellucid::scene
