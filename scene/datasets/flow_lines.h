// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/datasets/dataset.h"

namespace pellucid::scene {

/// Each row makes stream lines, path lines or vortex lines of a flow, from random seeds: in place
/// of the line data of Baeza Rojo et al. 2019.
///@{
const DatasetRow& benzene_dataset();
const DatasetRow& bfs_dataset();
const DatasetRow& trefoil_dataset();
const DatasetRow& helicopter_dataset();
const DatasetRow& ecmwf_dataset();
const DatasetRow& icon_dataset();
///@}

}  // namespace pellucid::scene
