// SPDX-License-Identifier: GPL-3.0-or-later
// The points of an OpenVDB file, which readers/vdb/parse_points.cpp finds.
#include <fmt/format.h>

#include "core/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/point_blocks.h"
#include "readers/vdb/vdb_file.h"

namespace pellucid::geometry {
namespace {

PointSet read_vdb_points(const std::filesystem::path& path) {
  try {
    return points_of(readers::read_vdb_point_blocks(path));
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: not a valid .vdb file: {}", path.string(), error.what()));
  }
}

}  // namespace

FormatRow vdb_format() {
  return {.ending = ".vdb", .title = "OpenVDB point grids", .read_points = read_vdb_points};
}

}  // namespace pellucid::geometry
