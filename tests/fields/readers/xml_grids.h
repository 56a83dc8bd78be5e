// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Writers of VTK's XML formats with any axes and any arrays of points and cells.

#include <fmt/format.h>
#include <array>

#include <functional>
#include <string>
#include <vector>

#include "core/vec.h"
#include "tests/fields/readers/vtk_files.h"

namespace pellucid::fields::xml_grids {

using Axes = std::array<std::vector<double>, 3>;
using VectorAt = std::function<Vec3(const Vec3&)>;
using NumberAt = std::function<double(const Vec3&)>;

/// `count` positions from `first` on.
inline std::vector<double> evenly(double first, double step, int count) {
  std::vector<double> positions;
  for (int i = 0; i < count; ++i) positions.push_back(first + step * i);
  return positions;
}

/// Middles of the cells along each axis; of one position that itself.
inline Axes middles(const Axes& axes) {
  Axes middles;
  for (std::size_t a = 0; a < 3; ++a) {
    if (axes[a].size() == 1) middles[a] = axes[a];
    for (std::size_t i = 0; i + 1 < axes[a].size(); ++i)
      middles[a].push_back(0.5 * (axes[a][i] + axes[a][i + 1]));
  }
  return middles;
}

/// A flow that linear interpolation keeps as it is.
inline Vec3 straight(const Vec3& x) { return {1 + x.x - 2 * x.z, x.y + x.z, 3 * x.x - x.y}; }

inline std::vector<Vec3> crossings(const Axes& axes) {
  std::vector<Vec3> points;
  for (const double z : axes[2])
    for (const double y : axes[1])
      for (const double x : axes[0]) points.emplace_back(x, y, z);
  return points;
}

inline std::string vectors(std::string_view name, const std::vector<Vec3>& places,
                           const VectorAt& velocity) {
  Positions values;
  for (const Vec3& x : places) values.push_back(velocity(x));
  return vtk_files::array(name, "Float64", 3, vtk_files::numbers(values));
}

inline std::string scalars(std::string_view name, const std::vector<Vec3>& places,
                           const NumberAt& value, std::string_view type = "Float64") {
  std::string text;
  for (const Vec3& x : places) text += fmt::format("{} ", value(x));
  return vtk_files::array(name, type, 1, text);
}

inline std::string extent_of(const Axes& axes) {
  return fmt::format("0 {} 0 {} 0 {}", axes[0].size() - 1, axes[1].size() - 1, axes[2].size() - 1);
}

inline std::string data(std::string_view of_points, std::string_view of_cells) {
  return fmt::format("<PointData>{}</PointData><CellData>{}</CellData>", of_points, of_cells);
}

/// Text of a .vtr; the arrays as vectors() and scalars() write them.
inline std::string rectilinear(const Axes& axes, std::string_view of_points,
                               std::string_view of_cells = {}) {
  std::string coordinates;
  for (const auto& axis : axes) {
    std::string text;
    for (const double x : axis) text += fmt::format("{} ", x);
    coordinates += vtk_files::array("axis", "Float64", 1, text);
  }
  return vtk_files::xml("RectilinearGrid",
                        fmt::format("<RectilinearGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">{1}"
                                    "<Coordinates>{2}</Coordinates></Piece></RectilinearGrid>",
                                    extent_of(axes), data(of_points, of_cells), coordinates));
}

/// Text of a .vts of the same points.
inline std::string structured(const Axes& axes, std::string_view of_points,
                              std::string_view of_cells = {}) {
  return vtk_files::xml(
      "StructuredGrid",
      fmt::format("<StructuredGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">{1}"
                  "<Points>{2}</Points></Piece></StructuredGrid>",
                  extent_of(axes), data(of_points, of_cells),
                  vtk_files::array("points", "Float64", 3, vtk_files::numbers(crossings(axes)))));
}

/// A cell of an unstructured grid: VTK's number of its type, and its points.
struct Cell {
  int type;
  std::vector<int> points;
};

/// Text of a .vtu.
inline std::string unstructured(const std::vector<Vec3>& points, const std::vector<Cell>& cells,
                                std::string_view of_points, std::string_view of_cells = {}) {
  std::string connectivity, offsets, types;
  std::size_t end = 0;
  for (const Cell& cell : cells) {
    for (const int point : cell.points) connectivity += fmt::format("{} ", point);
    offsets += fmt::format("{} ", end += cell.points.size());
    types += fmt::format("{} ", cell.type);
  }
  return vtk_files::xml(
      "UnstructuredGrid",
      fmt::format("<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">{}<Points>{}"
                  "</Points><Cells>{}{}{}</Cells></Piece></UnstructuredGrid>",
                  points.size(), cells.size(), data(of_points, of_cells),
                  vtk_files::array("points", "Float64", 3, vtk_files::numbers(points)),
                  vtk_files::array("connectivity", "Int64", 1, connectivity),
                  vtk_files::array("offsets", "Int64", 1, offsets),
                  vtk_files::array("types", "UInt8", 1, types)));
}

/// The hexahedra between the crossings.
inline std::vector<Cell> hexahedra(const Axes& axes) {
  const int nx = int(axes[0].size()), ny = int(axes[1].size()), nz = int(axes[2].size());
  const auto at = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
  std::vector<Cell> cells;
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i)
        cells.push_back(
            {12,
             {at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
              at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)}});
  return cells;
}

}  // namespace pellucid::fields::xml_grids
