// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fields/levels/level.h"

namespace pellucid::fields {

/// Joins levels that are blocks of one lattice, as a domain decomposition writes them: side by
/// side, the first samples of one a cell behind the last of the other, or sharing layers of equal
/// samples. Blocks whose union is a box become one level. Cells that lie between others, with
/// corners in several blocks, become levels of their own, of two layers or more (add_seams()). So
/// no cell is missing between blocks. What lies within another level, or is of another lattice,
/// stays.
///@{
std::vector<ScalarLevel> joined_blocks(std::vector<ScalarLevel> levels);
std::vector<VectorLevel> joined_blocks(std::vector<VectorLevel> levels);
std::vector<DoubleVectorLevel> joined_blocks(std::vector<DoubleVectorLevel> levels);
///@}

/// Adds levels that hold the cells between blocks which joined_blocks() cannot join: all their
/// corners are samples of blocks of one lattice, but not of one block.
void add_seams(std::vector<ScalarLevel>& levels);

}  // namespace pellucid::fields
