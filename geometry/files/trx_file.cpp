// SPDX-License-Identifier: GPL-3.0-or-later
// .trx, tractography of the tee-ar-ex specification (github.com/tee-ar-ex/trx-spec): a .zip file,
// of which each member is an array in C's order, little-endian, whose name tells its columns and
// its numbers' type:
//
//     header.json               NB_VERTICES, NB_STREAMLINES, and the voxels' grid, which is not
//     needed positions.3.float16       of all vertices, in scanner coordinates (RAS, mm)
//     offsets.uint32            of each streamline's first vertex; the end of the last may follow
//     dpv/fa.float32            data per vertex
//     dps/length.float32        data per streamline, dps/seed.3.float32 with three columns
//
// Groups of streamlines (groups/, dpg/) are left out.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/options/split.h"
#include "geometry/files/color_names.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/trx_tracks.h"
#include "readers/archives/archive_file.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "members are little-endian");

template <class T>
double number_at(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

/// IEEE 754's binary16.
double half_at(const std::byte* bytes) {
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  const int exponent = bits >> 10 & 31, fraction = bits & 1023;
  double size = std::ldexp(fraction, -24);
  if (exponent == 31) size = fraction ? NAN : INFINITY;
  if (exponent > 0 && exponent < 31) size = std::ldexp(1024 + fraction, exponent - 25);
  return bits >> 15 ? -size : size;
}

struct NumberKind {
  std::string_view name;
  std::size_t size;
  double (*at)(const std::byte*);
};
constexpr NumberKind kinds[] = {{"float16", 2, half_at},
                                {"float32", 4, number_at<float>},
                                {"float64", 8, number_at<double>},
                                {"int8", 1, number_at<std::int8_t>},
                                {"int16", 2, number_at<std::int16_t>},
                                {"int32", 4, number_at<std::int32_t>},
                                {"int64", 8, number_at<std::int64_t>},
                                {"uint8", 1, number_at<std::uint8_t>},
                                {"uint16", 2, number_at<std::uint16_t>},
                                {"uint32", 4, number_at<std::uint32_t>},
                                {"uint64", 8, number_at<std::uint64_t>}};

/// A member "dpv/NAME.COLUMNS.TYPE", of which one column need not be said.
struct Member {
  const Block* block;
  std::string name;  // without the folder
  std::size_t columns = 1;
  const NumberKind* kind = nullptr;

  std::size_t rows() const { return block->bytes.size() / (kind->size * columns); }
  double at(std::size_t row, std::size_t column) const {
    return kind->at(&block->bytes[(row * columns + column) * kind->size]);
  }
};

std::size_t columns_of(std::string_view text, const Block& block) {
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), columns);
  constexpr std::size_t most = 1000;
  if (error != std::errc() || end != text.end() || columns < 1 || columns > most)
    block.fail(fmt::format("has '{}' columns; accepted: 1 … {}", text, most));
  return columns;
}

Member member_of(const Block& block, std::string_view within) {
  auto parts = split(std::string_view(block.name).substr(within.size()), '.');
  Member member{&block, std::string(parts.front())};
  const auto kind = std::ranges::find(kinds, parts.back(), &NumberKind::name);
  if (parts.size() < 2 || parts.size() > 3 || kind == std::end(kinds))
    block.fail("is not of the form NAME.TYPE or NAME.COLUMNS.TYPE, as positions.3.float32");
  member.kind = kind;
  if (parts.size() == 3) member.columns = columns_of(parts[1], block);
  if (block.bytes.size() % (member.kind->size * member.columns) != 0)
    block.fail("does not end with a whole row");
  return member;
}

/// The only member that is called so.
Member named(const Blocks& files, std::string_view name) {
  const Block* found = nullptr;
  for (const Block& block : files.all())
    if (block.name.starts_with(name) && block.name.substr(name.size()).starts_with('.')) {
      if (found) block.fail(fmt::format("and '{}' are both there", found->name));
      found = &block;
    }
  if (!found) throw BlockError(fmt::format("it has no {}", name));
  return member_of(*found, "");
}

std::uint64_t count_in(const nlohmann::json& header, const char* key) {
  const auto found = header.find(key);
  if (found == header.end() || !found->is_number_unsigned())
    throw BlockError(fmt::format("header.json: {}: accepted: a whole number", key));
  return *found;
}

std::vector<std::uint64_t> offsets_of(const Member& member, std::uint64_t lines,
                                      std::uint64_t vertices) {
  if (member.rows() != lines && member.rows() != lines + 1)
    member.block->fail(fmt::format("has {} rows for {} streamlines", member.rows(), lines));
  std::vector<std::uint64_t> offsets(lines + 1, vertices);
  for (std::uint64_t i = 0; i < member.rows(); ++i) {
    const double offset = member.at(i, 0);
    const double before = i == 0 ? 0 : double(offsets[i - 1]);
    if (!(offset >= before && offset <= double(vertices)) || (i == 0 && offset != 0))
      member.block->fail(
          fmt::format("begins streamline {} at vertex {} of {}", i, offset, vertices));
    offsets[i] = std::uint64_t(offset);
  }
  if (offsets.back() != vertices) member.block->fail("leaves vertices out");
  return offsets;
}

/// Columns called as colours are have the names of their channels, bytes of them in 255ths.
std::string column_name(const Member& member, std::size_t column) {
  constexpr std::array<const char*, 4> channels{"red", "green", "blue", "alpha"};
  const bool is_color = is_color_name(member.name) && (member.columns == 3 || member.columns == 4);
  if (is_color) return channels[column];
  return member.columns == 1 ? member.name : fmt::format("{}_{}", member.name, column);
}

class TrxReader {
 public:
  explicit TrxReader(const Blocks& files) : files_(files) {}

  FileLines read() {
    if (!files_.find("header.json"))
      throw BlockError(fmt::format("it has no header.json at its root{}",
                                   files_.all().empty() ? "" : ", but " + files_.all()[0].name));
    const nlohmann::json header = parse_json("header.json", files_.text("header.json"));
    const std::uint64_t vertices = count_in(header, "NB_VERTICES");
    const std::uint64_t lines = count_in(header, "NB_STREAMLINES");
    read_positions(named(files_, "positions"), vertices);
    lines_.offsets = offsets_of(named(files_, "offsets"), lines, vertices);
    for (const Block& block : files_.all()) {
      if (block.name.starts_with("dpv/")) add_per_vertex(member_of(block, "dpv/"));
      if (block.name.starts_with("dps/")) add_per_line(member_of(block, "dps/"));
    }
    take_attributes(std::move(attributes_), lines_);
    return std::move(lines_);
  }

 private:
  void read_positions(const Member& member, std::uint64_t vertices) {
    if (member.columns != 3 || member.rows() != vertices)
      member.block->fail(fmt::format("has {} rows of {} columns; expected {} of 3", member.rows(),
                                     member.columns, vertices));
    lines_.positions.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
      lines_.positions.emplace_back(member.at(i, 0), member.at(i, 1), member.at(i, 2));
  }

  std::vector<double>& column_of(const Member& member, std::size_t column) {
    std::vector<double>& values = attributes_[column_name(member, column)];
    if (!values.empty()) member.block->fail("has the name of another one");
    return values;
  }
  static double unit_of(const Member& member) {
    const bool is_color = is_color_name(member.name) && member.kind->name == "uint8";
    return is_color ? 1 / 255. : 1;
  }

  void add_per_vertex(const Member& member) {
    check_rows(member, lines_.positions.size(), "vertices");
    for (std::size_t column = 0; column < member.columns; ++column) {
      std::vector<double>& values = column_of(member, column);
      for (std::size_t i = 0; i < member.rows(); ++i)
        values.push_back(unit_of(member) * member.at(i, column));
    }
  }

  void add_per_line(const Member& member) {
    check_rows(member, lines_.line_count(), "streamlines");
    for (std::size_t column = 0; column < member.columns; ++column) {
      std::vector<double>& values = column_of(member, column);
      for (std::size_t line = 0; line < member.rows(); ++line) {
        const double value = unit_of(member) * member.at(line, column);
        values.resize(lines_.offsets[line + 1], value);
        lines_.values[column_name(member, column)].push_back(value);
      }
    }
  }

  static void check_rows(const Member& member, std::size_t count, std::string_view what) {
    if (member.rows() != count)
      member.block->fail(fmt::format("has {} rows for {} {}", member.rows(), count, what));
  }

  const Blocks& files_;
  FileLines lines_;
  VertexAttributes attributes_;
};

FileLines read_trx(const std::filesystem::path& path) {
  try {
    return lines_of_trx(readers::read_archive(path));
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: not a valid .trx file: {}", path.string(), error.what()));
  }
}

}  // namespace

FileLines lines_of_trx(const Blocks& files) {
  try {
    return TrxReader(files).read();
  } catch (const InputError& error) {  // of the header's text
    throw BlockError(error.what());
  }
}

FormatRow trx_format() {
  return {.ending = ".trx",
          .title = "tracks of the tee-ar-ex format",
          .traps =
              "in scanner coordinates (RAS, mm); data per streamline are at each of its points; "
              "groups are left out",
          .read_lines = read_trx};
}

}  // namespace pellucid::geometry
