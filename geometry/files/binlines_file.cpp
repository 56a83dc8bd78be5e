// SPDX-License-Identifier: GPL-3.0-or-later
// .binlines, as LineVis reads and writes it (github.com/chrismile/LineVis, BinLinesLoader): 32-bit
// little-endian numbers and floats,
//
//   version (1 or 2), lines, attributes; then of each line its points, their positions, and one
//   attribute's values after another; then, in version 2, whether positions were normalized,
//   whether names follow (one per attribute: length, characters), and what is not read here:
//   directions of ribbons and the outline of a simulation grid.

#include <fmt/format.h>

#include "geometry/files/byte_reader.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

/// The names of version 2, or numbers.
std::vector<std::string> read_names(ByteReader& bytes, std::uint32_t version, std::size_t count) {
  std::vector<std::string> names(count);
  for (std::size_t k = 0; k < count; ++k) names[k] = fmt::format("attribute{}", k);
  if (version < 2) return names;
  bytes.number<std::uint32_t>();  // positions normalized: to what, the file does not say
  if (bytes.number<std::uint32_t>() != 0)
    for (std::string& name : names) name = bytes.take(bytes.number<std::uint32_t>(), "a name");
  return names;
}

FileLines read_binlines(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const auto version = bytes.number<std::uint32_t>();
  if (version != 1 && version != 2)
    bytes.fail(fmt::format("version {} of .binlines; accepted: 1, 2", version));
  const auto line_count = bytes.number<std::uint32_t>();
  const auto attribute_count = bytes.number<std::uint32_t>();
  constexpr std::uint32_t most_attributes = 1024;
  if (attribute_count > most_attributes)
    bytes.fail(fmt::format("{} attributes; accepted: up to {}", attribute_count, most_attributes));
  FileLines lines;
  std::vector<std::vector<double>> columns(attribute_count);
  for (std::uint32_t k = 0; k < line_count; ++k) {
    const auto points = bytes.number<std::uint32_t>();
    const std::vector<float> xyz = bytes.numbers<float>(3ull * points, "positions");
    for (std::uint32_t i = 0; i < points; ++i)
      lines.positions.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    for (std::vector<double>& column : columns) {
      const std::vector<float> values = bytes.numbers<float>(points, "an attribute");
      column.insert(column.end(), values.begin(), values.end());
    }
    lines.offsets.push_back(lines.positions.size());
  }
  const std::vector<std::string> names = read_names(bytes, version, attribute_count);
  VertexAttributes attributes;
  for (std::uint32_t k = 0; k < attribute_count; ++k) attributes[names[k]] = std::move(columns[k]);
  take_attributes(std::move(attributes), lines);
  return lines;
}

}  // namespace

FormatRow binlines_format() {
  return {.ending = ".binlines", .title = "lines of LineVis", .read_lines = read_binlines};
}

}  // namespace pellucid::geometry
