// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Writers of the VTK formats, XML and legacy.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/fields/sampled/grid_samples.h"

namespace pellucid::fields::vtk_files {

namespace fs = std::filesystem;

inline std::string numbers(const Positions& vectors) {
  std::string text;
  for (const Vec3& v : vectors) text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
  return text;
}

inline std::string coordinates(int axis, double warp) {
  std::string text;
  for (int i = 0; i < grid_size[axis]; ++i) text += fmt::format("{} ", along(axis, i, warp));
  return text + "\n";
}

/// Legacy binary files are big-endian.
template <class T>
std::string big_endian_bytes(const Positions& vectors) {
  std::string bytes = native_bytes<T>(vectors);
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(T))
    std::reverse(bytes.begin() + long(i), bytes.begin() + long(i + sizeof(T)));
  return bytes;
}

inline std::string xml(std::string_view type, std::string_view body) {
  return fmt::format(
      "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "{}</VTKFile>\n",
      type, body);
}

inline std::string array(std::string_view name, std::string_view type, int components,
                         std::string_view text) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n"
      "{}</DataArray>\n",
      type, name, components, text);
}

inline std::string point_data(const Positions& vectors) {
  return "<PointData>\n" + array("velocity", "Float64", 3, numbers(vectors)) + "</PointData>\n";
}

inline std::string extent() {
  return fmt::format("0 {} 0 {} 0 {}", grid_size[0] - 1, grid_size[1] - 1, grid_size[2] - 1);
}

inline std::string origin_and_spacing() {
  return fmt::format("Origin=\"{} {} {}\" Spacing=\"{} {} {}\"", grid_box.min.x, grid_box.min.y,
                     grid_box.min.z, step(0), step(1), step(2));
}

inline void write_vti(const fs::path& path, const Velocity& velocity) {
  write_bytes(path, xml("ImageData", fmt::format("<ImageData WholeExtent=\"{0}\" {1}>\n"
                                                 "<Piece Extent=\"{0}\">\n{2}</Piece></ImageData>",
                                                 extent(), origin_and_spacing(),
                                                 point_data(evaluate(rectilinear(0), velocity)))));
}

inline std::string appended_image(std::string_view whole_extent, std::string_view geometry,
                                  const std::string& bytes) {
  const std::uint64_t length = bytes.size();
  const std::string header(reinterpret_cast<const char*>(&length), sizeof length);
  return xml("ImageData",
             fmt::format("<ImageData WholeExtent=\"{0}\" {1}>\n<Piece Extent=\"{0}\"><PointData>"
                         "<DataArray type=\"Float64\" Name=\"velocity\" NumberOfComponents=\"3\" "
                         "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n"
                         "<AppendedData encoding=\"raw\">\n_{2}{3}</AppendedData>\n",
                         whole_extent, geometry, header, bytes));
}

inline void write_appended_vti(const fs::path& path, const Velocity& velocity) {
  write_bytes(path, appended_image(extent(), origin_and_spacing(),
                                   native_bytes<double>(evaluate(rectilinear(0), velocity))));
}

/// The image's own axes are the world's, turned: y, z, x.
inline void write_turned_vti(const fs::path& path, const Velocity& velocity) {
  Positions vectors;
  for (int i = 0; i < grid_size[0]; ++i)
    for (int k = 0; k < grid_size[2]; ++k)
      for (int j = 0; j < grid_size[1]; ++j)
        vectors.push_back(velocity({along(0, i, 0), along(1, j, 0), along(2, k, 0)}));
  const std::string whole =
      fmt::format("0 {} 0 {} 0 {}", grid_size[1] - 1, grid_size[2] - 1, grid_size[0] - 1);
  const std::string geometry =
      fmt::format("Origin=\"{} {} {}\" Spacing=\"{} {} {}\" Direction=\"0 0 1 1 0 0 0 1 0\"",
                  grid_box.min.x, grid_box.min.y, grid_box.min.z, step(1), step(2), step(0));
  write_bytes(path, appended_image(whole, geometry, native_bytes<double>(vectors)));
}

inline void write_vtr(const fs::path& path, const Velocity& velocity) {
  std::string axes;
  for (int axis = 0; axis < 3; ++axis)
    axes += array(std::string(1, "xyz"[axis]), "Float64", 1, coordinates(axis, 0.3));
  write_bytes(path,
              xml("RectilinearGrid",
                  fmt::format("<RectilinearGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">\n{1}"
                              "<Coordinates>\n{2}</Coordinates></Piece></RectilinearGrid>",
                              extent(), point_data(evaluate(rectilinear(0.3), velocity)), axes)));
}

inline std::string points(const Positions& positions) {
  return "<Points>\n" + array("Points", "Float64", 3, numbers(positions)) + "</Points>\n";
}

inline void write_vts(const fs::path& path, const Velocity& velocity) {
  const Positions positions = curvilinear();
  write_bytes(
      path,
      xml("StructuredGrid",
          fmt::format("<StructuredGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">\n{1}{2}"
                      "</Piece></StructuredGrid>",
                      extent(), point_data(evaluate(positions, velocity)), points(positions))));
}

struct Cells {
  std::vector<std::vector<int>> points;
  std::vector<int> types;

  void add(int type, std::vector<int> corners) {
    points.push_back(std::move(corners));
    types.push_back(type);
  }
};

/// Hexahedra, columns of six tetrahedra or two wedges in turn; and a triangle and a line, which
/// have no volume.
inline Cells mixed_cells() {
  constexpr int tetra = 10, hexahedron = 12, wedge = 13, triangle = 5, line = 3;
  Cells cells;
  cells.add(triangle, {0, 1, grid_size[0]});
  for (int k = 0; k + 1 < grid_size[2]; ++k)
    for (int j = 0; j + 1 < grid_size[1]; ++j)
      for (int i = 0; i + 1 < grid_size[0]; ++i) {
        const int a = (k * grid_size[1] + j) * grid_size[0] + i, row = grid_size[0],
                  layer = grid_size[0] * grid_size[1];
        const int c[8] = {a,         a + 1,         a + row + 1,         a + row,
                          a + layer, a + layer + 1, a + layer + row + 1, a + layer + row};
        if (i % 3 == 0) {
          cells.add(hexahedron, {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
        } else if (i % 3 == 1) {
          const int ring[7] = {1, 2, 3, 7, 4, 5, 1};  // the edges around the diagonal 0-6
          for (int e = 0; e < 6; ++e) cells.add(tetra, {c[0], c[ring[e]], c[ring[e + 1]], c[6]});
        } else {
          cells.add(wedge, {c[0], c[1], c[2], c[4], c[5], c[6]});
          cells.add(wedge, {c[0], c[2], c[3], c[4], c[6], c[7]});
        }
      }
  cells.add(line, {0, 1});
  return cells;
}

inline void write_vtu(const fs::path& path, const Velocity& velocity) {
  const Positions positions = rectilinear(0.2);
  const Cells cells = mixed_cells();
  std::string connectivity, offsets, types;
  std::size_t offset = 0;
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    connectivity += fmt::format("{}\n", fmt::join(cells.points[i], " "));
    offsets += fmt::format("{}\n", offset += cells.points[i].size());
    types += fmt::format("{}\n", cells.types[i]);
  }
  write_bytes(
      path, xml("UnstructuredGrid",
                fmt::format(
                    "<UnstructuredGrid><Piece NumberOfPoints=\"{}\" "
                    "NumberOfCells=\"{}\">\n{}{}<Cells>\n{}{}{}</Cells></Piece>"
                    "</UnstructuredGrid>",
                    positions.size(), cells.types.size(), point_data(evaluate(positions, velocity)),
                    points(positions), array("connectivity", "Int64", 1, connectivity),
                    array("offsets", "Int64", 1, offsets), array("types", "UInt8", 1, types))));
}

inline std::string legacy(bool binary, std::string_view geometry, std::string_view vectors) {
  return fmt::format(
      "# vtk DataFile Version 3.0\nwritten by a test\n{}\n{}\nPOINT_DATA {}\n"
      "VECTORS velocity {}\n{}\n",
      binary ? "BINARY" : "ASCII", geometry, grid_size[0] * grid_size[1] * grid_size[2],
      binary ? "float" : "double", vectors);
}

inline std::string dimensions() {
  return fmt::format("DIMENSIONS {} {} {}", grid_size[0], grid_size[1], grid_size[2]);
}

inline void write_legacy_image(const fs::path& path, const Velocity& velocity) {
  const std::string geometry =
      fmt::format("DATASET STRUCTURED_POINTS\n{}\nORIGIN {} {} {}\nSPACING {} {} {}", dimensions(),
                  grid_box.min.x, grid_box.min.y, grid_box.min.z, step(0), step(1), step(2));
  write_bytes(path,
              legacy(true, geometry, big_endian_bytes<float>(evaluate(rectilinear(0), velocity))));
}

inline void write_legacy_rectilinear(const fs::path& path, const Velocity& velocity) {
  std::string geometry = "DATASET RECTILINEAR_GRID\n" + dimensions() + "\n";
  for (int axis = 0; axis < 3; ++axis)
    geometry += fmt::format("{}_COORDINATES {} double\n{}", "XYZ"[axis], grid_size[axis],
                            coordinates(axis, 0.3));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(rectilinear(0.3), velocity))));
}

inline void write_legacy_structured(const fs::path& path, const Velocity& velocity) {
  const Positions positions = curvilinear();
  const std::string geometry = fmt::format("DATASET STRUCTURED_GRID\n{}\nPOINTS {} double\n{}",
                                           dimensions(), positions.size(), numbers(positions));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(positions, velocity))));
}

inline void write_legacy_unstructured(const fs::path& path, const Velocity& velocity) {
  const Positions positions = rectilinear(0.2);
  const Cells cells = mixed_cells();
  std::string list;
  std::size_t length = 0;
  for (const auto& corners : cells.points) {
    list += fmt::format("{} {}\n", corners.size(), fmt::join(corners, " "));
    length += corners.size() + 1;
  }
  const std::string geometry =
      fmt::format("DATASET UNSTRUCTURED_GRID\nPOINTS {} double\n{}CELLS {} {}\n{}CELL_TYPES {}\n{}",
                  positions.size(), numbers(positions), cells.types.size(), length, list,
                  cells.types.size(), fmt::join(cells.types, "\n"));
  write_bytes(path, legacy(false, geometry, numbers(evaluate(positions, velocity))));
}

}  // namespace pellucid::fields::vtk_files
