// SPDX-License-Identifier: GPL-3.0-or-later
// .tck, the tracks of MRtrix (mrtrix.readthedocs.io, "Tracks file format"): a header of text,
// "key: value" lines between "mrtrix tracks" and "END", which says the numbers' type and where they
// begin; then three numbers a point, in scanner coordinates, mm. A point of NaN ends a track, one
// of infinities the file.

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "core/options/parameters.h"
#include "geometry/files/byte_reader.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

constexpr std::string_view magic = "mrtrix tracks";

using TckHeader = std::map<std::string, std::string, std::less<>>;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

/// The header's lines up to "END"; of a key that is there twice the last one.
TckHeader read_header(const ByteReader& bytes) {
  std::string_view rest = bytes.content();
  if (!rest.starts_with(magic)) bytes.fail("not a file of tracks; expected 'mrtrix tracks'");
  TckHeader header;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == rest.npos) break;
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (line == "END") return header;
    const std::size_t colon = line.find(':');
    if (colon != line.npos)
      header[std::string(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
  }
  bytes.fail("its header has no line 'END'");
}

/// "file: . 67": the data begin at byte 67 of this file.
std::uint64_t offset_of(const TckHeader& header, const ByteReader& bytes) {
  const auto file = header.find("file");
  if (file == header.end()) bytes.fail("its header does not say where the data begin: 'file: . N'");
  double offset = 0;
  const std::string_view text = file->second;
  if (!text.starts_with('.') || !parse_number(trimmed(text.substr(1)), offset) || offset < 0 ||
      offset != std::floor(offset) || offset > double(bytes.content().size()))
    bytes.fail(fmt::format("file: {}; accepted: '. N', a byte of this file", text));
  return std::uint64_t(offset);
}

/// Of tracks that were ended, empty ones among them, there are as many as the header counts; a
/// count of 0 is that of a file whose writer was not done with it.
void check_count(const TckHeader& header, std::size_t ended, const ByteReader& bytes) {
  const auto count = header.find("count");
  double expected = 0;
  if (count == header.end() || !parse_number(count->second, expected) || expected == 0) return;
  if (expected != double(ended))
    bytes.fail(fmt::format("count: {}, but it holds {} tracks: truncated?", count->second, ended));
}

template <class Number>
FileLines read_tracks(ByteReader& bytes, const TckHeader& header) {
  FileLines lines;
  std::size_t ended = 0;
  const auto end_line = [&] {
    if (lines.positions.size() > lines.offsets.back())
      lines.offsets.push_back(lines.positions.size());
  };
  while (bytes.bytes_left() > 0) {
    const auto xyz = bytes.numbers<Number>(3, "a point");
    if (std::isinf(xyz[0])) {
      ended += lines.positions.size() > lines.offsets.back();
      end_line();
      check_count(header, ended, bytes);
      return lines;
    }
    if (std::isnan(xyz[0]))
      end_line(), ++ended;
    else
      lines.positions.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  bytes.fail("no point of infinities ends the tracks: truncated?");
}

FileLines read_tck(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const TckHeader header = read_header(bytes);
  const auto type = header.find("datatype");
  const std::string_view name = type == header.end() ? "" : std::string_view(type->second);
  if (name != "Float32LE" && name != "Float32BE" && name != "Float64LE" && name != "Float64BE")
    bytes.fail(
        fmt::format("datatype: {}; accepted: Float32LE, Float32BE, Float64LE, Float64BE", name));
  bytes.set_big_endian(name.ends_with("BE"));
  bytes.seek(offset_of(header, bytes));
  return name.starts_with("Float64") ? read_tracks<double>(bytes, header)
                                     : read_tracks<float>(bytes, header);
}

void append_point(std::string& out, const Vec3& x) {
  static_assert(std::endian::native == std::endian::little, "the header says LE");
  for (int axis = 0; axis < 3; ++axis) {
    const float value = float(x[axis]);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof raw);
  }
}

/// Where the data begin stands in the header, whose length hangs on it.
std::string header_for(std::size_t count, const std::string& origin) {
  const std::string head = fmt::format(
      "{}\ndatatype: Float32LE\ncount: {}\ncommand_history: {}\nfile: . ", magic, count, origin);
  const auto whole = [&](std::size_t offset) { return fmt::format("{}{}\nEND\n", head, offset); };
  std::size_t offset = whole(0).size();
  while (whole(offset).size() != offset) offset = whole(offset).size();
  return whole(offset);
}

/// Positions in floats, as other readers expect them; nothing but positions is kept.
void write_tck(const std::filesystem::path& path, const LineSet& lines, const std::string& origin) {
  std::string out = header_for(lines.line_count(), origin);
  for (std::size_t line = 0; line < lines.line_count(); ++line) {
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
      append_point(out, lines.positions[i]);
    append_point(out, Vec3(NAN));
  }
  append_point(out, Vec3(INFINITY));
  write_text(path, out);
}

}  // namespace

FormatRow tck_format() {
  return {.ending = ".tck",
          .title = "tracks of MRtrix",
          .traps = "in scanner coordinates, mm; positions alone are written, in floats",
          .read_lines = read_tck,
          .write_lines = write_tck,
          .writes_scalars = false};
}

}  // namespace pellucid::geometry
