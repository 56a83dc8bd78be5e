// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// Fibre tracks of a brain: in place of the diffusion data of Baeza Rojo et al. 2019, Fig. 1.
const DatasetRow& dt_mri_dataset();

}  // namespace pellucid::scene
