// SPDX-License-Identifier: GPL-3.0-or-later
// The points of an OpenVDB file, which readers/vdb/parse_points.cpp finds. Numbers become scalars
// of their name.

#include "geometry/files/vdb_points.h"

#include <fmt/format.h>

#include "core/error.h"
#include "geometry/files/mesh_formats.h"
#include "readers/vdb/vdb_file.h"

namespace pellucid::geometry {
namespace {

constexpr std::string_view column_mark = "column:";

VertexAttributes columns_of(const Blocks& blocks, std::size_t count) {
  VertexAttributes attributes;
  for (const Block& block : blocks.all()) {
    if (!block.name.starts_with(column_mark)) continue;
    const auto values = block.values<double>();
    if (values.size() != count) block.fail("does not have one value per point");
    attributes[block.name.substr(column_mark.size())].assign(values.begin(), values.end());
  }
  return attributes;
}

}  // namespace

PointSet points_of(const Blocks& blocks) {
  const Block& positions = blocks.at("positions");
  const auto numbers = positions.values<double>();
  if (positions.components != 3) positions.fail("does not have three coordinates per point");
  PointSet set;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    set.positions.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  take_attributes(columns_of(blocks, set.positions.size()), set);
  return set;
}

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
