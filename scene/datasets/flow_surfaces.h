// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// Each row makes stream surfaces of a flow, of random seed curves: in place of the surface data of
/// Baeza Rojo et al. 2019, Figs. 7 and 8.
///@{
const DatasetRow& tornado_dataset();
const DatasetRow& delta_wing_dataset();
///@}

}  // namespace pellucid::scene
