// SPDX-License-Identifier: GPL-3.0-or-later
// .binlines, as LineVis reads and writes it (github.com/chrismile/LineVis, BinLinesLoader): 32-bit
// little-endian numbers and floats,
//
//   version (1 or 2), lines, attributes; then of each line its points, their positions, and one
//   attribute's values after another; then, in version 2, whether positions were normalized,
//   whether names follow (one per attribute: length, characters), and what is not read here:
//   directions of ribbons and the outline of a simulation grid.

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie");

class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path)
      : file_(path.string()), content_(read_text(path)) {}

  std::uint32_t number() {
    std::uint32_t value;
    std::memcpy(&value, take(sizeof value, "a number").data(), sizeof value);
    return value;
  }

  /// Nothing is allocated for more than the file holds.
  std::vector<float> floats(std::uint64_t count, std::string_view what) {
    const std::string_view bytes = take(count * sizeof(float), what);
    std::vector<float> values(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  std::string text() {
    const std::uint32_t length = number();
    return std::string(take(length, "a name"));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: byte {}: {}", file_, position_, what));
  }

 private:
  std::string_view take(std::uint64_t count, std::string_view what) {
    const std::uint64_t left = content_.size() - position_;
    if (count > left)
      fail(fmt::format("{} of {} bytes, but {} are left: truncated?", what, count, left));
    const std::string_view bytes = std::string_view(content_).substr(position_, count);
    position_ += count;
    return bytes;
  }

  std::string file_, content_;
  std::uint64_t position_ = 0;
};

/// The names of version 2, or numbers.
std::vector<std::string> read_names(Bytes& bytes, std::uint32_t version, std::size_t count) {
  std::vector<std::string> names(count);
  for (std::size_t k = 0; k < count; ++k) names[k] = fmt::format("attribute{}", k);
  if (version < 2) return names;
  bytes.number();  // positions normalized: to what, the file does not say
  if (bytes.number() != 0)
    for (std::string& name : names) name = bytes.text();
  return names;
}

LineSet read_binlines(const std::filesystem::path& path) {
  Bytes bytes(path);
  const std::uint32_t version = bytes.number();
  if (version != 1 && version != 2)
    bytes.fail(fmt::format("version {} of .binlines; accepted: 1, 2", version));
  const std::uint32_t line_count = bytes.number(), attribute_count = bytes.number();
  constexpr std::uint32_t most_attributes = 1024;
  if (attribute_count > most_attributes)
    bytes.fail(fmt::format("{} attributes; accepted: up to {}", attribute_count, most_attributes));
  LineSet lines;
  std::vector<std::vector<double>> columns(attribute_count);
  for (std::uint32_t k = 0; k < line_count; ++k) {
    const std::uint32_t points = bytes.number();
    const std::vector<float> xyz = bytes.floats(3ull * points, "positions");
    for (std::uint32_t i = 0; i < points; ++i)
      lines.positions.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    for (std::vector<double>& column : columns) {
      const std::vector<float> values = bytes.floats(points, "an attribute");
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
