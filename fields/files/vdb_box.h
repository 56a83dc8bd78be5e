// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for what uses .vdb files' grids alone.

#include <openvdb/openvdb.h>

namespace pellucid::fields {

/// Says whether the active voxels, those of tiles among them, fill `box`. A file may claim many in
/// a tile: who keeps each of them asks for their number first.
template <class Grid>
bool fills_a_box(const Grid& grid, const openvdb::CoordBBox& box) {
  return double(grid.activeVoxelCount()) == box.dim().asVec3d().product();
}

}  // namespace pellucid::fields
