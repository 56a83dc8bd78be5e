// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// OpenVDB's grids as blocks. Grid number i of a file has
//
//     i.name, i.value                  texts: its name, and OpenVDB's name of its values' type
//     i.class                          i32: openvdb::GridClass
//     i.affine                         16 × f64, row by row: world from index; none when not affine
//     i.background                     one value; it and the following only where the tree is here
//     i.origins, i.masks, i.values     of each leaf: i32 × 3, u64 × 8, 512 values
//     i.tiles, i.tile_values           of each tile that is active or has another value than the
//                                      background: i32 × 5 (level, x, y, z, active), and its value

#include <openvdb/openvdb.h>

#include <string>
#include <vector>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// A VdbGrid is one grid of a file. Its tree is there for grids of float, double, vec3s and vec3d
/// that were asked for.
struct VdbGrid {
  std::string name;
  std::string value_type;       // as OpenVDB names it
  openvdb::GridBase::Ptr grid;  // nullptr: only its name and type were read
};

/// Returns the matrix that takes indices, as a row from the left, to the world: the file's to the
/// last bit. A Transform made of it may differ, since OpenVDB takes scales from differences of
/// positions.
openvdb::Mat4d affine_of(const openvdb::GridBase& grid);

/// Says whether the grid's values are vectors of three floats or doubles.
bool holds_vectors(const VdbGrid& grid);

/// Writes grid `number`, its tree too when `with_tree` and its type is one of those above; its
/// leaves lose their values, so that they are in memory once.
void write_grid(int number, openvdb::GridBase& grid, bool with_tree, BlockWriter& out);

/// Builds all grids of the blocks anew. Throws BlockError for leaves off their lattice, for leaves
/// and tiles 2^30 voxels or more from the origin, and for numbers of values that do not fit. Blocks
/// of many leaves are zero afterwards, to be in memory once.
std::vector<VdbGrid> grids_of(const Blocks& blocks);

}  // namespace pellucid::readers
