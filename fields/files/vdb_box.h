// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for what uses .vdb files' grids alone.

#include <openvdb/openvdb.h>

namespace pellucid::fields {

/// Says whether the active voxels are single ones (so that the file holds each of them) and fill
/// `box`, in voxels.
template <class Grid>
bool fills_a_box(const Grid& grid, const openvdb::CoordBBox& box) {
  const openvdb::Vec3d size(box.dim().asVec3d());
  return grid.tree().activeTileCount() == 0 &&
         double(grid.activeVoxelCount()) == size.x() * size.y() * size.z();
}

}  // namespace pellucid::fields
