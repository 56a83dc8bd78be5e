// SPDX-License-Identifier: GPL-3.0-or-later
// .hair, Cem Yuksel's hair models (cemyuksel.com/research/hairmodels): a header of 128 bytes; then,
// where its bits say so, the segments of each strand (u16), and of all points positions, thickness,
// transparency and colour (f32). Opacity is 1 - transparency; what all points share stands in the
// header.

#include <fmt/format.h>

#include "geometry/files/byte_reader.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

enum Arrays : std::uint32_t {
  has_segments = 1,
  has_points = 2,
  has_thickness = 4,
  has_transparency = 8,
  has_colors = 16
};

struct HairHeader {
  std::uint32_t strands = 0, points = 0, arrays = 0, segments = 0;
  float thickness = 0, transparency = 0;
  Vec3 color{0};
};

HairHeader read_header(ByteReader& bytes) {
  if (!bytes.content().starts_with("HAIR"))
    bytes.fail("not a hair model; expected 'HAIR' at its front");
  bytes.seek(4);
  HairHeader header;
  header.strands = bytes.number<std::uint32_t>();
  header.points = bytes.number<std::uint32_t>();
  header.arrays = bytes.number<std::uint32_t>();
  header.segments = bytes.number<std::uint32_t>();
  header.thickness = bytes.number<float>();
  header.transparency = bytes.number<float>();
  for (int c = 0; c < 3; ++c) header.color[c] = bytes.number<float>();
  bytes.seek(128);
  if (!(header.arrays & has_points)) bytes.fail("it has no points");
  if (header.points > bytes.bytes_left() / (3 * sizeof(float)))
    bytes.fail(fmt::format("{} points, but {} bytes are left", header.points, bytes.bytes_left()));
  return header;
}

/// Ends of the strands among the points: one more than their segments each.
std::vector<std::uint64_t> read_offsets(ByteReader& bytes, const HairHeader& header) {
  std::vector<std::uint16_t> segments;
  if (header.arrays & has_segments)
    segments = bytes.numbers<std::uint16_t>(header.strands, "segments");
  else if (header.strands > header.points)
    bytes.fail(fmt::format("{} strands of {} points", header.strands, header.points));
  std::vector<std::uint64_t> offsets{0};
  for (std::uint32_t k = 0; k < header.strands; ++k)
    offsets.push_back(offsets.back() + 1 + (segments.empty() ? header.segments : segments[k]));
  if (offsets.back() != header.points)
    bytes.fail(
        fmt::format("its strands have {} points, but there are {}", offsets.back(), header.points));
  return offsets;
}

FileLines read_hair(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const HairHeader header = read_header(bytes);
  FileLines lines;
  lines.offsets = read_offsets(bytes, header);
  const std::uint64_t count = header.points;
  const auto xyz = bytes.numbers<float>(3 * count, "points");
  const auto thickness = header.arrays & has_thickness
                             ? bytes.numbers<float>(count, "thickness")
                             : std::vector<float>(count, header.thickness);
  const auto transparency = header.arrays & has_transparency
                                ? bytes.numbers<float>(count, "transparency")
                                : std::vector<float>(count, header.transparency);
  const bool colored = header.arrays & has_colors;
  const auto rgb = bytes.numbers<float>(colored ? 3 * count : 0, "colours");
  for (std::uint64_t i = 0; i < count; ++i) {
    lines.positions.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    const Vec3 color = colored ? Vec3(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]) : header.color;
    lines.colors.emplace_back(Rgba(color, 1 - transparency[i]));
  }
  lines.scalars["thickness"].assign(thickness.begin(), thickness.end());
  return lines;
}

}  // namespace

FormatRow hair_format() {
  return {.ending = ".hair",
          .title = "hair models of C. Yuksel",
          .traps = "opacity is 1 - transparency; thickness is a scalar",
          .read_lines = read_hair};
}

}  // namespace pellucid::geometry
