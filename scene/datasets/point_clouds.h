// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// Each row makes points with the structures of the data of Baeza Rojo et al. 2019, Figs. 1, 4
/// and 11.
///@{
const DatasetRow& dark_sky_dataset();
const DatasetRow& ctbl_dataset();
const DatasetRow& viscous_fingers_dataset();
///@}

}  // namespace pellucid::scene
