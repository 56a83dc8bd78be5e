// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/staggered_grid.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::fields {
namespace {

constexpr openvdb::Index64 most_of_tiles = 1 << 24;  // voxels, each of which becomes one

template <class Grid>
openvdb::GridBase::Ptr centred(const Grid& grid, const std::string& name) {
  if (grid.activeVoxelCount() - grid.tree().activeLeafVoxelCount() > most_of_tiles)
    throw InputError(fmt::format(
        "{}: it is staggered and has tiles of more than 2^24 voxels; accepted: fewer", name));
  const auto out = openvdb::gridPtrCast<Grid>(grid.copyGridWithNewTree());
  out->setGridClass(openvdb::GRID_UNKNOWN);
  const auto faces = grid.getConstAccessor();
  auto middles = out->getAccessor();
  const auto centre = [&](const openvdb::Coord& at) {
    typename Grid::ValueType mean = faces.getValue(at), upper;
    for (int axis = 0; axis < 3; ++axis) {
      openvdb::Coord next = at;
      ++next[axis];
      if (!faces.probeValue(next, upper)) return;
      mean[axis] += (upper[axis] - mean[axis]) / 2;
    }
    middles.setValueOn(at, mean);
  };
  for (auto value = grid.cbeginValueOn(); value; ++value) {
    openvdb::CoordBBox box;
    value.getBoundingBox(box);
    for (const openvdb::Coord& at : box) centre(at);
  }
  if (out->activeVoxelCount() == 0)
    throw InputError(fmt::format(
        "{}: it is staggered, and no voxel has both faces across every axis; accepted: two active "
        "voxels or more along each",
        name));
  return out;
}

}  // namespace

openvdb::GridBase::Ptr at_centres(const openvdb::GridBase::Ptr& grid, const std::string& name) {
  if (!grid || grid->getGridClass() != openvdb::GRID_STAGGERED) return grid;
  if (const auto floats = openvdb::gridPtrCast<openvdb::Vec3SGrid>(grid))
    return centred(*floats, name);
  if (const auto doubles = openvdb::gridPtrCast<openvdb::Vec3DGrid>(grid))
    return centred(*doubles, name);
  throw InputError(fmt::format("{}: it is staggered, and of {}; accepted: vec3s or vec3d", name,
                               grid->valueType()));
}

}  // namespace pellucid::fields
