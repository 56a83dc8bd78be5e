// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for the readers of .vdb files alone.

#include <openvdb/io/DelayedLoadMetadata.h>
#include <openvdb/openvdb.h>

#include <filesystem>
#include <memory>

#include "core/error.h"
#include "fields/files/vdb_precheck.h"

namespace pellucid::fields {

/// Opens an OpenVDB file once precheck_vdb() has checked its claims. Throws InputError when it is
/// missing or claims too much, openvdb::Exception when OpenVDB cannot read it.
inline std::unique_ptr<openvdb::io::File> open_vdb(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": no such file");
  precheck_vdb(path);
  openvdb::initialize();
  openvdb::io::DelayedLoadMetadata::unregisterType();  // it trusts a count of its own, unused here
  auto file = std::make_unique<openvdb::io::File>(path.string());
  file->open(false);  // not delayed: what cannot be read is known now
  return file;
}

/// Says whether the active voxels are single ones (so that the file holds each of them) and fill
/// `box`, in voxels.
template <class Grid>
bool fills_a_box(const Grid& grid, const openvdb::CoordBBox& box) {
  const openvdb::Vec3d size(box.dim().asVec3d());
  return grid.tree().activeTileCount() == 0 &&
         double(grid.activeVoxelCount()) == size.x() * size.y() * size.z();
}

}  // namespace pellucid::fields
