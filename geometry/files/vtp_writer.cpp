// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML formats of poly data and unstructured grids, version 1.0, arrays appended raw: VTK's
// own writer crashes where memory ends, and over lines without a segment.
#include "geometry/files/vtp_writer.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <fstream>
#include <ranges>
#include <span>
#include <utility>

#include "core/files/output_file.h"
#include "core/files/write_failure.h"
#include "geometry/files/scalar_names.h"

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
        text += c;  // control characters were refused
    }
  return text;
}

/// A Piece is the elements of a <Piece> and the bytes that they refer to. Arrays and notes are not
/// copied: they have to live until it is written.
class Piece {
 public:
  /// Adds an array of numbers of VTK's type to the element that is open.
  template <class T>
  void add(std::string_view name, std::string_view type, int components,
           std::span<const T> values) {
    elements_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, escaped(name), components, place(std::as_bytes(values)));
  }
  /// Adds a text to the field data of the whole file.
  void note(std::string_view name, const std::string& text) {
    const std::span<const char> ended(text.c_str(), text.size() + 1);  // with its 0
    notes_ += fmt::format(
        "<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        name, place(std::as_bytes(ended)));
  }
  void open(std::string_view element) { elements_ += fmt::format("<{}>\n", element); }
  void close(std::string_view element) { elements_ += fmt::format("</{}>\n", element); }

  /// `type` is VTK's name of the kind of data set, "PolyData" or "UnstructuredGrid".
  void write(const std::filesystem::path& path, std::string_view type,
             std::string_view counts) const {
    OutputFile file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
        << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" << type
        << ">\n<FieldData>\n"
        << notes_ << "</FieldData>\n<Piece " << counts << ">\n"
        << elements_ << "</Piece>\n</" << type << ">\n<AppendedData encoding=\"raw\">\n_";
    for (const std::span<const std::byte> bytes : data_) {
      const std::uint64_t size = bytes.size();
      out.write(reinterpret_cast<const char*>(&size), sizeof size);
      out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(size));
    }
    out << "\n</AppendedData>\n</VTKFile>\n";
    out.close();
    if (!out) fail_stream(path);
    file.commit();
  }

 private:
  /// Returns where the bytes begin in the data.
  std::uint64_t place(std::span<const std::byte> bytes) {
    data_.push_back(bytes);
    return std::exchange(size_, size_ + sizeof(std::uint64_t) + bytes.size());
  }

  std::string notes_, elements_;
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

void add_attributes(const Vertices& vertices, Piece& piece) {
  piece.open(vertices.normals.empty() ? "PointData" : "PointData Normals=\"Normals\"");
  if (!vertices.normals.empty()) piece.add("Normals", "Float64", 3, numbers_of(vertices.normals));
  if (!vertices.colors.empty()) piece.add("RGBA", "Float32", 4, numbers_of(vertices.colors));
  if (!vertices.importance.empty())
    piece.add("importance", "Float32", 1, std::span<const float>(vertices.importance));
  for (const auto& [name, values] : vertices.scalars)
    piece.add(name, "Float64", 1, std::span<const double>(values));
  piece.close("PointData");
}

/// Cells by the points that they join, one behind another, and where each ends.
struct Cells {
  std::vector<std::int64_t> connectivity, ends;

  template <class Points>
  void add(const Points& points) {
    for (const auto point : points) connectivity.push_back(std::int64_t(point));
    ends.push_back(std::int64_t(connectivity.size()));
  }
};

Cells cells_of(const TriangleMesh& mesh) {
  Cells cells;
  for (const auto& triangle : mesh.triangles) cells.add(triangle);
  return cells;
}

/// Of a line without a segment nothing is drawn.
Cells cells_of(const LineSet& lines) {
  Cells cells;
  for (std::size_t line = 0; line < lines.line_count(); ++line)
    if (const std::uint64_t begin = lines.offsets[line], end = lines.offsets[line + 1];
        end - begin > 1)
      cells.add(std::views::iota(begin, end));
  return cells;
}

Cells cells_of(const PointSet& points) {
  Cells cells;
  for (std::int64_t i = 0; i < std::int64_t(points.positions.size()); ++i) cells.add(std::array{i});
  return cells;
}

void add_cells(const Cells& cells, Piece& piece) {
  piece.add("connectivity", "Int64", 1, std::span<const std::int64_t>(cells.connectivity));
  piece.add("offsets", "Int64", 1, std::span<const std::int64_t>(cells.ends));
}

/// What a cell of poly data is among, and VTK's number of its type in an unstructured grid.
struct CellKind {
  std::string_view element;  // "Polys"
  std::uint8_t type;
};
CellKind kind_of(const TriangleMesh&) { return {"Polys", 5}; }
CellKind kind_of(const LineSet&) { return {"Lines", 4}; }
CellKind kind_of(const PointSet&) { return {"Verts", 1}; }

template <class Geometry>
void write_poly_data(const std::filesystem::path& path, const Geometry& geometry,
                     const std::string& origin) {
  check_vtk_names(path, geometry);
  const Cells cells = cells_of(geometry);
  const std::string_view element = kind_of(geometry).element;
  Piece piece;
  piece.note("origin", origin);
  add_points(geometry, piece);
  add_attributes(geometry, piece);
  piece.open(element);
  add_cells(cells, piece);
  piece.close(element);
  std::string counts = fmt::format("NumberOfPoints=\"{}\"", geometry.positions.size());
  for (const std::string_view each : {"Verts", "Lines", "Strips", "Polys"})
    counts += fmt::format(" NumberOf{}=\"{}\"", each, each == element ? cells.ends.size() : 0);
  piece.write(path, "PolyData", counts);
}

template <class Geometry>
void write_unstructured(const std::filesystem::path& path, const Geometry& geometry,
                        const std::string& origin) {
  check_vtk_names(path, geometry);
  const Cells cells = cells_of(geometry);
  const std::vector<std::uint8_t> types(cells.ends.size(), kind_of(geometry).type);
  Piece piece;
  piece.note("origin", origin);
  add_points(geometry, piece);
  add_attributes(geometry, piece);
  piece.open("Cells");
  add_cells(cells, piece);
  piece.add("types", "UInt8", 1, std::span<const std::uint8_t>(types));
  piece.close("Cells");
  piece.write(path, "UnstructuredGrid",
              fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", geometry.positions.size(),
                          cells.ends.size()));
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin) {
  write_poly_data(path, mesh, origin);
}
void write_vtp_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin) {
  write_poly_data(path, lines, origin);
}
void write_vtp_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin) {
  write_poly_data(path, points, origin);
}
void write_vtu(const std::filesystem::path& path, const TriangleMesh& mesh,
               const std::string& origin) {
  write_unstructured(path, mesh, origin);
}
void write_vtu_lines(const std::filesystem::path& path, const LineSet& lines,
                     const std::string& origin) {
  write_unstructured(path, lines, origin);
}
void write_vtu_points(const std::filesystem::path& path, const PointSet& points,
                      const std::string& origin) {
  write_unstructured(path, points, origin);
}

}  // namespace pellucid::geometry
