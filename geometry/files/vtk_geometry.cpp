// SPDX-License-Identifier: GPL-3.0-or-later
// Reads VTK's files: polygons and polylines of .vtp and legacy .vtk, the cells of an unstructured
// grid. Every index has been checked where the file was parsed (readers/vtk/cell_rules.h).

#include "geometry/files/vtk_geometry.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkGeometryFilter.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "geometry/files/face_colors.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/vtk_attributes.h"
#include "geometry/files/vtp_writer.h"
#include "geometry/polygons/triangulate.h"
#include "readers/vtk/duplicate_solids.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_formats.h"
#include "readers/vtk/vtk_messages.h"

namespace pellucid::geometry {
namespace {

/// Polygons and lines as they are; of other data the lines, and the faces that bound its cells.
/// What the data hide is left out first: a face to a hidden cell bounds. One to a duplicate does
/// not: another piece has what lies behind it, and the filter leaves out what duplicates bring.
vtkSmartPointer<vtkPolyData> cells_of(vtkSmartPointer<vtkDataSet> data) {
  if (readers::hides_cells(data)) data = readers::cells_and_duplicate_solids(data);
  if (const auto polygons = vtkPolyData::SafeDownCast(data)) return polygons;
  const readers::VtkMessages messages;
  vtkNew<vtkGeometryFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

PointIds every_point(vtkDataSet& data) {
  PointIds points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  std::iota(points.begin(), points.end(), vtkIdType(0));
  return points;
}

/// Calls `visit(cell, points)` for each vertex cell, the last one first.
template <class Visit>
void for_each_vertex_cell(vtkDataSet& data, const Visit& visit) {
  const vtkNew<vtkIdList> ids;
  for (vtkIdType cell = data.GetNumberOfCells() - 1; cell >= 0; --cell) {
    const int type = data.GetCellType(cell);
    if (type != VTK_VERTEX && type != VTK_POLY_VERTEX) continue;
    data.GetCellPoints(cell, ids);
    visit(cell, std::span(ids->begin(), ids->end()));
  }
}

/// By point: whether all of its vertex cells are hidden or duplicates, and it has some.
std::vector<bool> hidden_by_cells(vtkDataSet& data) {
  std::vector<bool> hidden(std::size_t(data.GetNumberOfPoints()), false), shown = hidden;
  for_each_vertex_cell(data, [&](vtkIdType cell, std::span<const vtkIdType> points) {
    std::vector<bool>& marks = readers::hides_cell(&data, cell) ? hidden : shown;
    for (const vtkIdType point : points) marks[std::size_t(point)] = true;
  });
  for (std::size_t i = 0; i < hidden.size(); ++i) hidden[i] = hidden[i] && !shown[i];
  return hidden;
}

PointIds shown_points(vtkDataSet& data) {
  PointIds points = every_point(data);
  if (!readers::hides_cells(&data)) return points;
  const std::vector<bool> hidden = hidden_by_cells(data);
  std::erase_if(points, [&](vtkIdType i) {
    return readers::hides_point(&data, i) || hidden[std::size_t(i)];
  });
  return points;
}

PointIds each_once(PointIds ids) {
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Calls `visit(corners, number)` for each cell of an array.
template <class Visit>
void for_each_cell(vtkCellArray* cells, const Visit& visit) {
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  vtkIdType number = 0;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    visit(std::span(ids, std::size_t(count)), number++);
  }
}

void take_positions(vtkDataSet& data, Vertices& vertices) {
  vertices.positions.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    data.GetPoint(i, &vertices.positions[static_cast<std::size_t>(i)].x);
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void add_strip(std::span<const vtkIdType> ids, Triangles& triangles) {
  for (std::size_t k = 2; k < ids.size(); ++k) {
    const bool odd = k % 2 == 1;
    triangles.push_back(
        {std::uint32_t(ids[k - 2 + odd]), std::uint32_t(ids[k - 1 - odd]), std::uint32_t(ids[k])});
  }
}

/// Appends the triangles of polygons and strips; returns of each the number of its cell.
PointIds add_triangles(vtkPolyData& data, TriangleMesh& mesh) {
  PointIds cells;
  const vtkIdType polygons = data.GetNumberOfVerts() + data.GetNumberOfLines();
  for_each_cell(data.GetPolys(), [&](std::span<const vtkIdType> ids, vtkIdType cell) {
    const std::vector<std::uint32_t> corners(ids.begin(), ids.end());
    triangulate_polygon(mesh.positions, corners, mesh.triangles);
    cells.resize(mesh.triangles.size(), polygons + cell);
  });
  const vtkIdType strips = polygons + data.GetNumberOfPolys();
  for_each_cell(data.GetStrips(), [&](std::span<const vtkIdType> ids, vtkIdType cell) {
    add_strip(ids, mesh.triangles);
    cells.resize(mesh.triangles.size(), strips + cell);
  });
  return cells;
}

/// The colour of each triangle's cell.
FaceColors colors_of(vtkDataArray& colors, const PointIds& cells) {
  FaceColors result;
  result.have_alpha = colors.GetNumberOfComponents() == 4;
  result.colors.reserve(cells.size());
  for (const vtkIdType cell : cells) {
    Rgba color(1);
    for (int c = 0; c < colors.GetNumberOfComponents(); ++c)
      color[c] = float(colors.GetComponent(cell, c) / vtk_color_unit(colors));
    result.colors.push_back(color);
  }
  return result;
}

/// The colours of each point's cell; with its own alpha, where the cells have none.
void take_cell_colors(vtkDataArray& colors, const PointIds& cells, VertexAttributes& attributes,
                      Vertices& vertices) {
  if (colors.GetNumberOfComponents() == 4 && attributes.contains("alpha"))
    vertices.remarks.push_back("the alpha of its points is left out: its cells have one, too");
  take_vtk_colors(colors, cells, attributes);
}

/// The numbers of cells, each once; and those of points, where lines share some.
VertexAttributes line_values(vtkPolyData& data, const PointIds& points, const PointIds& cells,
                             const VertexAttributes& of_points) {
  VertexAttributes values = vtk_cell_scalars(data, each_once(cells));
  for (const auto& [name, column] : of_points) values.erase(name);
  if (const PointIds once = each_once(points); once.size() < points.size())
    values.merge(vtk_attributes(data, once));
  return values;
}

}  // namespace

FileMesh mesh_of(const vtkSmartPointer<vtkDataSet>& data_set) {
  const auto data = cells_of(data_set);
  FileMesh mesh;
  take_positions(*data, mesh);
  const PointIds cells = add_triangles(*data, mesh);
  VertexAttributes attributes = vtk_attributes(*data, every_point(*data));
  vtkDataArray* const colors = vtk_cell_colors(*data, attributes);
  take_vtk_attributes(std::move(attributes), mesh, colors);
  if (colors) color_faces(colors_of(*colors, cells), mesh);
  remark_greys(*data, mesh);
  mesh.face_scalars = vtk_cell_scalars(*data, cells);
  take_face_values(vtk_cell_scalars(*data, each_once(cells)), mesh);
  return mesh;
}

FileLines lines_of(const vtkSmartPointer<vtkDataSet>& data_set) {
  const auto data = cells_of(data_set);
  FileLines lines;
  PointIds points, cells;  // by vertex
  for_each_cell(data->GetLines(), [&](std::span<const vtkIdType> ids, vtkIdType line) {
    points.insert(points.end(), ids.begin(), ids.end());
    cells.resize(points.size(), data->GetNumberOfVerts() + line);
    lines.offsets.push_back(points.size());
  });
  lines.positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data->GetPoint(points[i], &lines.positions[i].x);
  VertexAttributes attributes = vtk_attributes(*data, points);
  if (vtkDataArray* colors = vtk_cell_colors(*data, attributes))
    take_cell_colors(*colors, cells, attributes, lines);
  lines.values = line_values(*data, points, cells, attributes);
  attributes.merge(vtk_cell_scalars(*data, cells));  // no two lines share a point here
  take_vtk_attributes(std::move(attributes), lines);
  remark_greys(*data, lines);
  return lines;
}

namespace {

/// The vertex cell of each point, the first of several that are shown; none where a point has none.
PointIds vertex_cells(vtkDataSet& data, const PointIds& points) {
  PointIds of_point(std::size_t(data.GetNumberOfPoints()), -1), cells;
  for_each_vertex_cell(data, [&](vtkIdType cell, std::span<const vtkIdType> corners) {
    if (readers::hides_cell(&data, cell)) return;
    for (const vtkIdType point : corners) of_point[std::size_t(point)] = cell;
  });
  for (const vtkIdType point : points) cells.push_back(of_point[std::size_t(point)]);
  return std::ranges::find(cells, -1) == cells.end() ? cells : PointIds();
}

/// What the vertex cells of points carry, where every point is one.
void add_of_vertex_cells(vtkDataSet& data, const PointIds& points, VertexAttributes& attributes,
                         PointSet& set) {
  if (data.GetCellData()->GetNumberOfArrays() == 0) return;
  const PointIds cells = vertex_cells(data, points);
  if (cells.empty()) return;
  if (vtkDataArray* colors = vtk_cell_colors(data, attributes))
    take_cell_colors(*colors, cells, attributes, set);
  attributes.merge(vtk_cell_scalars(data, cells));
}

}  // namespace

PointSet points_of(const vtkSmartPointer<vtkDataSet>& data) {
  const PointIds points = shown_points(*data);
  PointSet set;
  set.positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data->GetPoint(points[i], &set.positions[i].x);
  VertexAttributes attributes = vtk_attributes(*data, points);
  add_of_vertex_cells(*data, points, attributes, set);
  take_vtk_attributes(std::move(attributes), set);
  remark_greys(*data, set);
  return set;
}

namespace {

template <class Taken>
using TakeDataSet = Taken(const vtkSmartPointer<vtkDataSet>&);

/// What `take` makes of the file's data set.
template <class Taken, TakeDataSet<Taken>* take>
Taken read_vtk(const std::filesystem::path& path) {
  return take(readers::read_vtk_data_set(path));
}

FormatRow read_by_vtk(std::string_view ending, std::string_view title) {
  return {.ending = ending,
          .title = title,
          .read_mesh = read_vtk<FileMesh, mesh_of>,
          .read_lines = read_vtk<FileLines, lines_of>,
          .read_points = read_vtk<PointSet, points_of>};
}

}  // namespace

FormatRow vtp_format() {
  FormatRow row = read_by_vtk(".vtp", "VTK poly data");
  row.write_mesh = write_vtp;
  row.write_lines = write_vtp_lines;
  row.write_points = write_vtp_points;
  return row;
}

FormatRow vtu_format() {
  FormatRow row = read_by_vtk(".vtu", "VTK unstructured grid");
  row.write_mesh = write_vtu;
  row.write_lines = write_vtu_lines;
  row.write_points = write_vtu_points;
  return row;
}
FormatRow legacy_vtk_format() { return read_by_vtk(".vtk", "legacy VTK"); }
FormatRow stl_format() {
  const readers::VtkFormat& format = *readers::vtk_format(".stl");
  return {.ending = format.ending,
          .title = format.title,
          .traps = format.traps,
          .read_mesh = read_vtk<FileMesh, mesh_of>};
}

}  // namespace pellucid::geometry
