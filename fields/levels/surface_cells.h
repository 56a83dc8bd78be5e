// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/levels/level_field.h"

namespace pellucid::fields {

/// The part of a level's lattice cell where it is the finest: the whole cell but for the half cells
/// beyond the level's domain. It may reach under a finer level.
Box3 cell_box(const LevelField& field, const LatticeCell& cell);

/// The lattice cells in which the reconstruction may take `value`: samples that have weight there
/// lie on both sides of it, or on it. Cells that lie wholly under a finer level are left out. By
/// level, then in the order of the samples.
std::vector<LatticeCell> surface_cells(const LevelField& field, double value);

}  // namespace pellucid::fields
