// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// Adds the picture of the layers per pixel that a method made, to be seen beside the reference's;
/// pixels without a layer are white. Its scale tells 1 from 2 and from 8 layers; more than 32 look
/// alike.
void add_layer_picture(CellMeasurement& measured);

/// Adds by how many layers every pixel differs from the reference, which has the same size: as a
/// picture of the amount, white where it is none, and as the number of pixels over the signed
/// difference, of those pixels where either has a layer (Tian and Günther, Fig. 7).
void add_layer_difference(const CountImage& reference, CellMeasurement& measured);

}  // namespace pellucid::compare
