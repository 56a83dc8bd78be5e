// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML format for polygons and lines, version 1.0, arrays appended raw: VTK's own writer
// crashes where memory ends, and over lines without a segment.
#include "geometry/files/vtp_writer.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <span>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += std::uint8_t(c) < 0x20 ? '?' : c;  // XML has no such characters
    }
  return text;
}

/// A Piece is the elements of a <Piece> and the bytes that they refer to. Arrays are not copied:
/// they have to live until it is written.
class Piece {
 public:
  /// Adds an array of numbers of VTK's type to the element that is open.
  template <class T>
  void add(std::string_view name, std::string_view type, int components,
           std::span<const T> values) {
    elements_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, escaped(name), components, size_);
    data_.push_back(std::as_bytes(values));
    size_ += sizeof(std::uint64_t) + values.size_bytes();
  }
  void open(std::string_view element) { elements_ += fmt::format("<{}>\n", element); }
  void close(std::string_view element) { elements_ += fmt::format("</{}>\n", element); }

  void write(const std::filesystem::path& path, std::string_view counts) const {
    OutputFile file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece "
        << counts << ">\n"
        << elements_ << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    for (const std::span<const std::byte> bytes : data_) {
      const std::uint64_t size = bytes.size();
      out.write(reinterpret_cast<const char*>(&size), sizeof size);
      out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(size));
    }
    out << "\n</AppendedData>\n</VTKFile>\n";
    out.close();
    if (!out) throw WorkError(fmt::format("{}: cannot write: is the disk full?", path.string()));
    file.commit();
  }

 private:
  std::string elements_;
  std::vector<std::span<const std::byte>> data_;
  std::uint64_t size_ = 0;  // of the data, each array with its own size before it
};

/// The numbers of vectors one after another.
template <class Vector>
auto numbers_of(const std::vector<Vector>& vectors) {
  using Number = typename Vector::value_type;
  static_assert(sizeof(Vector) == Vector::length() * sizeof(Number));
  return std::span<const Number>(reinterpret_cast<const Number*>(vectors.data()),
                                 vectors.size() * std::size_t(Vector::length()));
}

void add_points(const Vertices& vertices, Piece& piece) {
  piece.open("Points");
  piece.add("Points", "Float64", 3, numbers_of(vertices.positions));
  piece.close("Points");
}

void add_scalars(const Vertices& vertices, Piece& piece) {
  for (const auto& [name, values] : vertices.scalars)
    piece.add(name, "Float64", 1, std::span<const double>(values));
}

void add_cells(std::string_view element, std::span<const std::int64_t> connectivity,
               std::span<const std::int64_t> ends, Piece& piece) {
  piece.open(element);
  piece.add("connectivity", "Int64", 1, connectivity);
  piece.add("offsets", "Int64", 1, ends);
  piece.close(element);
}

std::string counts(std::size_t points, std::size_t lines, std::size_t polygons) {
  return fmt::format(
      "NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\"",
      points, lines, polygons);
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh) {
  std::vector<std::int64_t> connectivity, ends;
  for (const auto& triangle : mesh.triangles) {
    connectivity.insert(connectivity.end(), triangle.begin(), triangle.end());
    ends.push_back(std::int64_t(connectivity.size()));
  }
  Piece piece;
  add_points(mesh, piece);
  piece.open("PointData Normals=\"Normals\"");
  if (!mesh.normals.empty()) piece.add("Normals", "Float64", 3, numbers_of(mesh.normals));
  if (!mesh.colors.empty()) piece.add("RGBA", "Float32", 4, numbers_of(mesh.colors));
  if (!mesh.importance.empty())
    piece.add("importance", "Float32", 1, std::span<const float>(mesh.importance));
  add_scalars(mesh, piece);
  piece.close("PointData");
  add_cells("Polys", connectivity, ends, piece);
  piece.write(path, counts(mesh.positions.size(), 0, mesh.triangles.size()));
}

void write_vtp_lines(const std::filesystem::path& path, const LineSet& lines) {
  std::vector<std::int64_t> connectivity, ends;
  for (std::size_t line = 0; line < lines.line_count(); ++line) {
    const std::uint64_t begin = lines.offsets[line], end = lines.offsets[line + 1];
    if (end - begin < 2) continue;  // no segment: nothing is drawn
    for (std::uint64_t i = begin; i < end; ++i) connectivity.push_back(std::int64_t(i));
    ends.push_back(std::int64_t(connectivity.size()));
  }
  Piece piece;
  add_points(lines, piece);
  piece.open("PointData");
  add_scalars(lines, piece);
  piece.close("PointData");
  add_cells("Lines", connectivity, ends, piece);
  piece.write(path, counts(lines.positions.size(), ends.size(), 0));
}

}  // namespace pellucid::geometry
