// SPDX-License-Identifier: GPL-3.0-or-later
// .trk, the tracks of TrackVis (trackvis.org/docs/?subsect=fileformat): a header of 1000 bytes;
// then of each track its number of points, of each point x, y, z and the scalars, and the track's
// properties, all of 4 bytes. Coordinates are mm from the corner of the first voxel, along the
// voxels' axes in the header's voxel_order; here they are brought to scanner coordinates (RAS, mm)
// as nibabel does (trk_axes.h).

#include <fmt/format.h>

#include "geometry/files/byte_reader.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/trk_axes.h"

namespace pellucid::geometry {
namespace {

constexpr std::uint64_t header_size = 1000;

struct TrkHeader {
  TrkImage image;
  std::vector<std::string> scalars, properties;  // a name per number
  std::int32_t tracks = 0;                       // 0: the file does not say
};

/// Bytes up to the first 0.
std::string text_of(std::string_view bytes) {
  return std::string(bytes.substr(0, bytes.find('\0')));
}

/// Names of 20 bytes for `count` numbers. One of several numbers has their count behind its end:
/// NAME_0, NAME_1, …
std::vector<std::string> read_names(ByteReader& bytes, int count, std::string_view otherwise) {
  std::vector<std::string> names;
  for (int k = 0; k < 10; ++k) {
    const std::string_view field = bytes.take(20, "a name");
    const std::string name = text_of(field);
    if (name.empty()) continue;
    const std::string_view rest = field.substr(std::min(name.size() + 1, field.size()));
    const int numbers =
        !rest.empty() && rest[0] >= '2' && rest[0] <= '9' && (rest.size() == 1 || rest[1] == '\0')
            ? rest[0] - '0'
            : 1;
    for (int i = 0; i < numbers; ++i)
      names.push_back(numbers == 1 ? name : fmt::format("{}_{}", name, i));
  }
  names.resize(std::size_t(count));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].empty()) names[i] = fmt::format("{}{}", otherwise, i);
  return names;
}

int read_count(ByteReader& bytes, std::string_view what) {
  const int count = bytes.number<std::int16_t>(what);
  if (count < 0 || count > 100) bytes.fail(fmt::format("{} {}; accepted: 0 … 100", count, what));
  return count;
}

/// Its size says in which order bytes are.
void find_byte_order(ByteReader& bytes) {
  if (!bytes.content().starts_with("TRACK"))
    bytes.fail("not a file of tracks; expected 'TRACK' at its front");
  bytes.seek(996);
  const auto size = bytes.number<std::int32_t>("the header's size");
  if (size == std::int32_t(header_size)) return;
  bytes.set_big_endian(true);
  bytes.seek(996);
  if (bytes.number<std::int32_t>() != std::int32_t(header_size))
    bytes.fail(fmt::format("its header's size is {}; accepted: {}", size, header_size));
}

TrkHeader read_header(ByteReader& bytes) {
  find_byte_order(bytes);
  TrkHeader header;
  bytes.seek(6);
  for (int& side : header.image.size) side = bytes.number<std::int16_t>();
  for (int axis = 0; axis < 3; ++axis) header.image.voxel_size[axis] = bytes.number<float>();
  bytes.seek(36);
  const int scalars = read_count(bytes, "scalars");
  header.scalars = read_names(bytes, scalars, "scalar");
  const int properties = read_count(bytes, "properties");
  header.properties = read_names(bytes, properties, "property");
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      header.image.ras_from_voxel[column][row] = bytes.number<float>();
  bytes.seek(948);
  header.image.voxel_order = text_of(bytes.take(4, "voxel_order"));
  bytes.seek(988);
  header.tracks = bytes.number<std::int32_t>();
  if (bytes.number<std::int32_t>("a version") == 1)
    header.image.ras_from_voxel[3][3] = 0;  // which had no matrix
  return header;
}

/// Points, with the scalars of each and the properties of their track.
void read_track(ByteReader& bytes, const TrkHeader& header, const Mat4& to_ras, FileLines& lines,
                std::vector<std::vector<double>>& columns) {
  const auto count = bytes.number<std::int32_t>("a number of points");
  if (count < 0) bytes.fail(fmt::format("a track of {} points", count));
  const std::size_t each = 3 + header.scalars.size();
  const auto numbers = bytes.numbers<float>(std::uint64_t(count) * each, "points");
  const auto properties = bytes.numbers<float>(header.properties.size(), "properties");
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    const float* point = numbers.data() + i * each;
    lines.positions.emplace_back(to_ras * glm::dvec4(point[0], point[1], point[2], 1));
    for (std::size_t k = 0; k < header.scalars.size(); ++k) columns[k].push_back(point[3 + k]);
    for (std::size_t k = 0; k < properties.size(); ++k)
      columns[header.scalars.size() + k].push_back(properties[k]);
  }
  for (std::size_t k = 0; k < properties.size(); ++k)
    lines.values[header.properties[k]].push_back(properties[k]);
  lines.offsets.push_back(lines.positions.size());
}

FileLines read_trk(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const TrkHeader header = read_header(bytes);
  std::vector<std::string> names = header.scalars;
  names.insert(names.end(), header.properties.begin(), header.properties.end());
  std::vector<std::vector<double>> columns(names.size());
  FileLines lines;
  const Mat4 to_ras = ras_from_trk(header.image, bytes, lines.remarks);
  for (bytes.seek(header_size); bytes.bytes_left() > 0;)
    read_track(bytes, header, to_ras, lines, columns);
  if (const std::size_t count = lines.line_count();
      header.tracks != 0 && header.tracks != std::int64_t(count))
    bytes.fail(fmt::format("its header says {} tracks, but it holds {}: truncated?", header.tracks,
                           count));
  VertexAttributes attributes;
  for (std::size_t k = 0; k < names.size(); ++k) attributes[names[k]] = std::move(columns[k]);
  take_attributes(std::move(attributes), lines);
  return lines;
}

}  // namespace

FormatRow trk_format() {
  return {.ending = ".trk",
          .title = "tracks of TrackVis",
          .traps =
              "brought to scanner coordinates (RAS, mm); a track's properties are at each of its "
              "points",
          .read_lines = read_trk};
}

}  // namespace pellucid::geometry
