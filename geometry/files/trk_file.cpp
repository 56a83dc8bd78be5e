// SPDX-License-Identifier: GPL-3.0-or-later
// .trk, the tracks of TrackVis (trackvis.org/docs/?subsect=fileformat): a header of 1000 bytes;
// then of each track its number of points, of each point x, y, z and the scalars, and the track's
// properties, all of 4 bytes. Coordinates are mm from the corner of the first voxel, along the
// voxels' axes in the header's voxel_order; here they are brought to scanner coordinates (RAS, mm)
// as nibabel does, by vox_to_ras.

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <glm/matrix.hpp>

#include "geometry/files/byte_reader.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::geometry {
namespace {

constexpr std::uint64_t header_size = 1000;

struct TrkHeader {
  Vec3 voxel_size{1};
  std::array<int, 3> size{};
  Mat4 ras_from_voxel{1};
  std::string voxel_order;
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
  for (int& side : header.size) side = bytes.number<std::int16_t>();
  for (int axis = 0; axis < 3; ++axis) header.voxel_size[axis] = bytes.number<float>();
  bytes.seek(36);
  const int scalars = read_count(bytes, "scalars");
  header.scalars = read_names(bytes, scalars, "scalar");
  const int properties = read_count(bytes, "properties");
  header.properties = read_names(bytes, properties, "property");
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      header.ras_from_voxel[column][row] = bytes.number<float>();
  bytes.seek(948);
  header.voxel_order = text_of(bytes.take(4, "voxel_order"));
  bytes.seek(988);
  header.tracks = bytes.number<std::int32_t>();
  return header;
}

/// An axis of the world, and whether a voxel's axis runs along it.
struct Direction {
  int axis = 0;
  bool positive = true;
};
using Directions = std::array<Direction, 3>;

/// The world's axes that the voxels' run along most, each once.
Directions directions_of(const Mat4& ras_from_voxel) {
  Directions directions;
  std::array<bool, 3> taken{};
  for (int column = 0; column < 3; ++column) {
    double most = -1;
    const Vec3 along(ras_from_voxel[column]);
    for (int axis = 0; axis < 3; ++axis)
      if (!taken[std::size_t(axis)] && std::abs(along[axis]) > most) {
        most = std::abs(along[axis]);
        directions[std::size_t(column)] = {axis, along[axis] >= 0};
      }
    taken[std::size_t(directions[std::size_t(column)].axis)] = true;
  }
  return directions;
}

/// "LPS": the voxels' axes run to the left, to the back, up.
Directions directions_of(const std::string& order, const ByteReader& bytes) {
  Directions directions;
  std::array<bool, 3> taken{};
  for (std::size_t k = 0; k < 3; ++k) {
    const char letter =
        k < order.size() ? char(std::toupper(static_cast<unsigned char>(order[k]))) : '?';
    const std::size_t place = std::string_view("RLAPSI").find(letter);
    if (place == std::string_view::npos || taken[place / 2])
      bytes.fail(fmt::format("voxel_order '{}'; accepted: three of R|L, A|P, S|I", order));
    directions[k] = {int(place / 2), place % 2 == 0};
    taken[place / 2] = true;
  }
  return directions;
}

/// Coordinates of the file to the world's.
Mat4 ras_from_file(const TrkHeader& header, const ByteReader& bytes) {
  Mat4 voxel_from_file(1);
  for (int axis = 0; axis < 3; ++axis) {
    voxel_from_file[axis][axis] = 1 / header.voxel_size[axis];
    voxel_from_file[3][axis] = -0.5;  // a voxel's centre is whole
  }
  if (header.ras_from_voxel[3][3] == 0) return voxel_from_file;  // the file does not say
  const Directions in_file =
      directions_of(header.voxel_order.empty() ? "LPS" : header.voxel_order, bytes);
  const Directions in_image = directions_of(header.ras_from_voxel);
  Mat4 image_from_voxel(0);  // axes exchanged, and turned round
  image_from_voxel[3][3] = 1;
  for (int from = 0; from < 3; ++from)
    for (int to = 0; to < 3; ++to) {
      const Direction &a = in_file[std::size_t(from)], &b = in_image[std::size_t(to)];
      if (a.axis != b.axis) continue;
      const bool same = a.positive == b.positive;
      image_from_voxel[from][to] = same ? 1 : -1;
      if (!same) image_from_voxel[3][to] = header.size[std::size_t(from)] - 1;
    }
  return header.ras_from_voxel * image_from_voxel * voxel_from_file;
}

void check(const TrkHeader& header, const ByteReader& bytes) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(header.voxel_size[axis] > 0))
      bytes.fail(fmt::format("voxel_size {} along axis {}; accepted: a length above 0",
                             header.voxel_size[axis], axis));
}

/// Points, with the scalars of each and the properties of their track.
void read_track(ByteReader& bytes, const TrkHeader& header, const Mat4& to_ras, LineSet& lines,
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
  lines.offsets.push_back(lines.positions.size());
}

LineSet read_trk(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const TrkHeader header = read_header(bytes);
  check(header, bytes);
  const Mat4 to_ras = ras_from_file(header, bytes);
  std::vector<std::string> names = header.scalars;
  names.insert(names.end(), header.properties.begin(), header.properties.end());
  std::vector<std::vector<double>> columns(names.size());
  LineSet lines;
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
