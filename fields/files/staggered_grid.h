// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for what uses .vdb files' grids alone.

#include <openvdb/openvdb.h>

#include <string>

namespace pellucid::fields {

/// Returns a grid whose vectors belong to the middle of their voxels. Of a staggered grid each
/// component belongs to the voxel's lower face across its axis: there it is the mean of both faces,
/// of voxels whose upper faces are active, too. Any other grid is returned as it is. Throws
/// InputError that begins with `name` for a staggered grid of no vectors, of tiles of more than
/// 2^24 voxels, and where nothing remains.
openvdb::GridBase::Ptr at_centres(const openvdb::GridBase::Ptr& grid, const std::string& name);

}  // namespace pellucid::fields
