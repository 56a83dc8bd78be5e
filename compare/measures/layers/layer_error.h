// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// Adds the curve of the RMSE over the pixels with n layers in the reference: where does a method
/// break? Each n up to 16 stands alone; beyond, four classes to each doubling share their pixels,
/// at the mean of their n. Pixels without a layer are left out. All have one size.
void add_layer_error(const Image& reference, const CountImage& reference_layers,
                     CellMeasurement& measured);

}  // namespace pellucid::compare
