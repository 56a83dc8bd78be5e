// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/inspect.h"
#include "app/info/vertices_contents.h"
#include "core/error.h"
#include "fmt/format.h"
#include "geometry/files/mesh_file.h"
#include "readers/vdb/vdb_file.h"

namespace pellucid::app {
namespace {

std::size_t components(float) { return 1; }
std::size_t components(double) { return 1; }
template <class Number>
std::size_t components(const openvdb::math::Vec3<Number>&) {
  return 3;
}

void add(double value, RangeCollector& ranges) { ranges.add(0, value); }
template <class Number>
void add(const openvdb::math::Vec3<Number>& value, RangeCollector& ranges) {
  for (int c = 0; c < 3; ++c) ranges.add(std::size_t(c), double(value[c]));
}

/// Ranges are over the active voxels.
template <class Grid>
bool take(const readers::VdbGrid& grid, FileContents& contents) {
  const auto typed = openvdb::gridPtrCast<Grid>(grid.grid);
  if (!typed) return false;
  RangeCollector ranges(components(typed->background()));
  for (auto value = typed->cbeginValueOn(); value; ++value) add(*value, ranges);
  contents.arrays.push_back(
      ranges.contents(grid.name, "grid", grid.value_type, typed->activeVoxelCount()));
  return true;
}

/// The box of the active voxels' centres, where the samples are; in the world.
void extend_bounds(const openvdb::GridBase& grid, Box3& box) {
  const openvdb::CoordBBox voxels = grid.evalActiveVoxelBoundingBox();
  if (voxels.empty()) return;
  for (int corner = 0; corner < 8; ++corner) {
    const openvdb::Coord ijk(corner & 1 ? voxels.max().x() : voxels.min().x(),
                             corner & 2 ? voxels.max().y() : voxels.min().y(),
                             corner & 4 ? voxels.max().z() : voxels.min().z());
    const openvdb::Vec3d x = ijk.asVec3d() * readers::affine_of(grid);
    box.extend({x.x(), x.y(), x.z()});
  }
}

nlohmann::ordered_json describe(const readers::VdbGrid& grid) {
  nlohmann::ordered_json json{{"name", grid.name}, {"type", grid.value_type}};
  if (!grid.grid) return json;
  const openvdb::Vec3d size = grid.grid->voxelSize();
  json["class"] = openvdb::GridBase::gridClassToString(grid.grid->getGridClass());
  json["voxel"] = {size.x(), size.y(), size.z()};
  return json;
}

bool holds_points(const readers::VdbGrid& grid) {
  return grid.value_type.find("ptdataidx") != std::string::npos;
}

void add_grid(const readers::VdbGrid& grid, FileContents& contents) {
  contents.more["grids"].push_back(describe(grid));
  if (!grid.grid) return;
  extend_bounds(*grid.grid, *contents.bounds);
  if (take<openvdb::FloatGrid>(grid, contents) || take<openvdb::DoubleGrid>(grid, contents) ||
      take<openvdb::Vec3SGrid>(grid, contents))
    return;
  take<openvdb::Vec3DGrid>(grid, contents);
}

}  // namespace

FileContents inspect_vdb(const std::filesystem::path& path) {
  const std::vector<readers::VdbGrid> grids = readers::read_vdb_grids(path);
  FileContents contents;
  contents.title = "OpenVDB";
  contents.kind = "grids";
  contents.bounds = Box3{};
  contents.counts = {{"grids", grids.size()}};
  for (const readers::VdbGrid& grid : grids) add_grid(grid, contents);
  if (std::ranges::none_of(grids, holds_points)) return contents;
  const geometry::PointSet points = geometry::read_points(path);
  const Box3 of_grids = *contents.bounds;
  add_vertices(points, contents);
  contents.counts.emplace_back("points", points.positions.size());
  contents.bounds->min = glm::min(contents.bounds->min, of_grids.min);
  contents.bounds->max = glm::max(contents.bounds->max, of_grids.max);
  return contents;
}

}  // namespace pellucid::app
