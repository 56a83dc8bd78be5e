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

/// Says whether voxels that are not active have values that mean something: beyond its narrow band
/// a level set has the band's width, with the sign of the side; around a fog there is none.
inline bool has_values_beyond(const openvdb::GridBase& grid) {
  return grid.getGridClass() == openvdb::GRID_LEVEL_SET ||
         grid.getGridClass() == openvdb::GRID_FOG_VOLUME;
}

/// Returns the box of the voxels whose values are a grid's: around the active ones, and a voxel
/// more on all sides where those beyond have values, too, so that no surface between both is cut.
template <class Grid>
openvdb::CoordBBox box_of_values(const Grid& grid) {
  openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  constexpr openvdb::Int32 far = 1 << 30;  // of a voxel's number, which has 31 bits
  const auto least = openvdb::Coord::minComponent(box.min(), openvdb::Coord(-far)),
             most = openvdb::Coord::maxComponent(box.max(), openvdb::Coord(far));
  const bool has_room = least == openvdb::Coord(-far) && most == openvdb::Coord(far);
  if (!box.empty() && has_room && has_values_beyond(grid)) box.expand(1);
  return box;
}

}  // namespace pellucid::fields
