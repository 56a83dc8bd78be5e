// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/point_blocks.h"

#include "core/options/split.h"
#include "geometry/files/component_suffix.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

constexpr std::string_view column_mark = "column:";

void take_column(const Block& block, std::size_t count, VertexAttributes& attributes) {
  const auto values = block.values<double>();
  const std::size_t components = block.components;
  if (values.size() != count * components) block.fail("does not have one row per point");
  const std::string name = block.name.substr(column_mark.size());
  for (std::size_t c = 0; c < components; ++c) {
    auto& column = attributes[components == 1 ? name : name + component_suffix(c, components)];
    column.resize(count);
    for (std::size_t i = 0; i < count; ++i) column[i] = values[i * components + c];
  }
}

}  // namespace

PointSet points_of(const Blocks& blocks) {
  const Block& positions = blocks.at("positions");
  const auto numbers = positions.values<double>();
  if (positions.components != 3) positions.fail("does not have three coordinates per point");
  PointSet set;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    set.positions.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  VertexAttributes attributes;
  for (const Block& block : blocks.all())
    if (block.name.starts_with(column_mark)) take_column(block, set.positions.size(), attributes);
  take_attributes(std::move(attributes), set);
  const std::string remarks = blocks.text("remarks");
  for (const std::string_view line : split(remarks, '\n'))
    if (!line.empty()) set.remarks.emplace_back(line);
  return set;
}

}  // namespace pellucid::geometry
