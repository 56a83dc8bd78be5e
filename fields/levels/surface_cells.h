// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/levels/level_field.h"

namespace pellucid::fields {

/// Returns the part of a lattice cell within its level's domain, in world units: the whole cell but
/// for the half cells beyond the domain. It may reach under a finer level.
Box3 cell_box(const LevelField& field, const LatticeCell& cell);

/// Returns the lattice cells in which the reconstruction may take `value`: samples that have weight
/// there lie on both sides of it, or on it. Cells that lie wholly under a finer level are left out.
/// They are ordered by level, then as the samples.
std::vector<LatticeCell> surface_cells(const LevelField& field, double value);

}  // namespace pellucid::fields
