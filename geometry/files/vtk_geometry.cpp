// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's files: polygons and polylines of .vtp and legacy .vtk, the cells of an unstructured grid.

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include <array>
#include <map>
#include <numeric>
#include <span>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/color_names.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/polygons/triangulate.h"
#include "readers/vtk/shown_cells.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_messages.h"

namespace pellucid::geometry {
namespace {

/// Polygons and lines as they are; of other data the lines, and the faces that bound its cells.
/// What the data hide is left out first: a face to a hidden cell bounds.
vtkSmartPointer<vtkPolyData> shown_cells(vtkSmartPointer<vtkDataSet> data,
                                         const std::filesystem::path& path) {
  if (readers::hides_cells(data)) data = readers::shown_cells(data, path);
  if (const auto polygons = vtkPolyData::SafeDownCast(data)) return polygons;
  const readers::VtkMessages messages;
  vtkNew<vtkGeometryFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> load_cells(const std::filesystem::path& path) {
  return shown_cells(readers::read_vtk_data_set(path), path);
}

using PointIds = std::vector<vtkIdType>;

void take_column(vtkDataArray& array, const PointIds& points, const std::string& name,
                 int component, double scale, VertexAttributes& attributes) {
  std::vector<double>& column = attributes[name];
  column.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    column[i] = array.GetComponent(points[i], component) / scale;
}

bool in_unit_interval(vtkDataArray& array) {
  for (int c = 0; c < array.GetNumberOfComponents(); ++c) {
    double range[2];
    array.GetFiniteRange(range, c);
    if (!(range[0] >= 0 && range[1] <= 1)) return false;
  }
  return true;
}

/// Whether an array of three or four components holds colours: it is called RGB, RGBA, Colors or
/// color; or it is called like one, or is what VTK draws by (COLOR_SCALARS of a legacy file), and
/// consists of bytes or of numbers in [0, 1].
bool is_color(vtkDataArray& array, const vtkDataArray* active) {
  const int components = array.GetNumberOfComponents();
  if (components < 3 || components > 4) return false;
  const std::string_view name = array.GetName() ? array.GetName() : "";
  if (name == "RGB" || name == "RGBA" || name == "Colors" || name == "color") return true;
  return (&array == active || is_color_name(name)) &&
         (array.GetDataType() == VTK_UNSIGNED_CHAR || in_unit_interval(array));
}

/// The colours among the arrays: what VTK draws by before others; null when there are none.
vtkDataArray* find_colors(vtkDataSetAttributes& arrays) {
  vtkDataArray* active = arrays.GetScalars();
  if (active && is_color(*active, active)) return active;
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k); array && is_color(*array, active)) return array;
  return nullptr;
}

double color_unit(vtkDataArray& array) {
  return array.GetDataType() == VTK_UNSIGNED_CHAR ? 255 : 1;
}

void take_colors(vtkDataArray& array, const PointIds& tuples, VertexAttributes& attributes) {
  static const char* const rgba[] = {"red", "green", "blue", "alpha"};
  for (int c = 0; c < array.GetNumberOfComponents(); ++c)
    take_column(array, tuples, rgba[c], c, color_unit(array), attributes);
}

/// Scalars keep their name, vectors give NAME_x, NAME_y, NAME_z; of bytes, the scalars red, green,
/// blue and alpha count in 255ths.
void take_array(vtkDataArray& array, const PointIds& points, VertexAttributes& attributes) {
  const std::string name = array.GetName() ? array.GetName() : "unnamed";
  const int components = array.GetNumberOfComponents();
  static const char* const axes[] = {"_x", "_y", "_z", "_w"};
  const bool is_channel = name == "red" || name == "green" || name == "blue" || name == "alpha";
  if (components == 1)
    return take_column(array, points, name, 0, is_channel ? color_unit(array) : 1, attributes);
  for (int c = 0; c < std::min(components, 4); ++c)
    take_column(array, points, name + axes[c], c, 1, attributes);
}

/// The points' attributes, in the order of `points`. VTK's own flags are none.
VertexAttributes attributes_of(vtkDataSet& data, const PointIds& points) {
  VertexAttributes attributes;
  vtkPointData& arrays = *data.GetPointData();
  vtkDataArray* const colors = find_colors(arrays);
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k); array && array != arrays.GetNormals() &&
                                                  array != colors &&
                                                  array != data.GetPointGhostArray())
      take_array(*array, points, attributes);
  if (colors) take_colors(*colors, points, attributes);
  if (vtkDataArray* normals = arrays.GetNormals())
    for (int c = 0; c < 3; ++c)
      take_column(*normals, points, std::string("n") + "xyz"[c], c, 1, attributes);
  return attributes;
}

/// The colours of cells, unless the points have some or the file has not one of each cell.
vtkDataArray* cell_colors(vtkPolyData& data, const VertexAttributes& of_points) {
  vtkDataArray* colors = find_colors(*data.GetCellData());
  const bool usable = colors && colors->GetNumberOfTuples() == data.GetNumberOfCells();
  return usable && !of_points.contains("red") ? colors : nullptr;
}

PointIds every_point(vtkDataSet& data) {
  PointIds points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  std::iota(points.begin(), points.end(), vtkIdType(0));
  return points;
}

PointIds shown_points(vtkDataSet& data) {
  PointIds points = every_point(data);
  std::erase_if(points, [&](vtkIdType i) { return readers::hides_point(&data, i); });
  return points;
}

/// Calls `visit(corners, number)` for each cell of an array. Throws InputError for a corner that is
/// no point of the data.
template <class Visit>
void for_each_cell(vtkPolyData& data, vtkCellArray* cells, const std::string& file,
                   const Visit& visit) {
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  vtkIdType number = 0;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    for (vtkIdType k = 0; k < count; ++k)
      if (ids[k] < 0 || ids[k] >= data.GetNumberOfPoints())
        throw InputError(fmt::format("{}: cell {}: vertex index {}, but the file has {} vertices",
                                     file, number, ids[k], data.GetNumberOfPoints()));
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
PointIds add_triangles(vtkPolyData& data, const std::string& file, TriangleMesh& mesh) {
  PointIds cells;
  const vtkIdType polygons = data.GetNumberOfVerts() + data.GetNumberOfLines();
  for_each_cell(data, data.GetPolys(), file, [&](std::span<const vtkIdType> ids, vtkIdType cell) {
    const std::vector<std::uint32_t> corners(ids.begin(), ids.end());
    triangulate_polygon(mesh.positions, corners, mesh.triangles);
    cells.resize(mesh.triangles.size(), polygons + cell);
  });
  const vtkIdType strips = polygons + data.GetNumberOfPolys();
  for_each_cell(data, data.GetStrips(), file, [&](std::span<const vtkIdType> ids, vtkIdType cell) {
    add_strip(ids, mesh.triangles);
    cells.resize(mesh.triangles.size(), strips + cell);
  });
  return cells;
}

/// Gives each triangle the colour of its cell. A vertex of cells of several colours becomes one
/// vertex for each; `points` are then the points that the vertices stand for.
std::vector<Rgba> color_by_cell(vtkDataArray& colors, const PointIds& cells, Triangles& triangles,
                                PointIds& points) {
  std::map<std::pair<vtkIdType, std::array<float, 4>>, std::uint32_t> vertices;
  std::vector<Rgba> result;
  points.clear();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    std::array<float, 4> color{1, 1, 1, 1};
    for (int c = 0; c < colors.GetNumberOfComponents(); ++c)
      color[std::size_t(c)] = float(colors.GetComponent(cells[i], c) / color_unit(colors));
    for (std::uint32_t& corner : triangles[i]) {
      const auto [found, is_new] =
          vertices.try_emplace({corner, color}, std::uint32_t(points.size()));
      if (is_new) {
        points.push_back(corner);
        result.emplace_back(color[0], color[1], color[2], color[3]);
      }
      corner = found->second;
    }
  }
  return result;
}

vtkSmartPointer<vtkPoints> to_points(const std::vector<Vec3>& positions) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), positions[i].x, positions[i].y, positions[i].z);
  return points;
}

template <class Array, class Vector>
vtkSmartPointer<Array> to_array(const char* name, const std::vector<Vector>& values) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(Vector::length());
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < Vector::length(); ++c)
      array->SetComponent(static_cast<vtkIdType>(i), c, values[i][c]);
  return array;
}

template <class Value>
void add_scalars(const std::string& name, const std::vector<Value>& values, vtkPolyData& data) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  data.GetPointData()->AddArray(array);
}

void save(const std::filesystem::path& path, vtkPolyData& data) {
  OutputFile out(path);
  const readers::VtkMessages messages;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(out.temporary().c_str());
  writer->SetInputData(&data);
  if (writer->Write() == 0 || !messages.first_line().empty())
    throw WorkError(fmt::format("{}: cannot write: {}", path.string(), messages.first_line()));
  out.commit();
}

TriangleMesh read_vtk_mesh(const std::filesystem::path& path) {
  const auto data = load_cells(path);
  TriangleMesh mesh;
  take_positions(*data, mesh);
  const PointIds cells = add_triangles(*data, path.string(), mesh);
  PointIds points = every_point(*data);
  VertexAttributes attributes = attributes_of(*data, points);
  if (vtkDataArray* colors = cell_colors(*data, attributes)) {
    const std::vector<Rgba> by_cell = color_by_cell(*colors, cells, mesh.triangles, points);
    const std::vector<Vec3> positions = std::move(mesh.positions);
    mesh.positions.clear();
    for (const vtkIdType point : points) mesh.positions.push_back(positions[std::size_t(point)]);
    take_attributes(attributes_of(*data, points), mesh);
    mesh.colors = by_cell;
  } else {
    take_attributes(std::move(attributes), mesh);
  }
  return mesh;
}

LineSet read_vtk_lines(const std::filesystem::path& path) {
  const auto data = load_cells(path);
  LineSet lines;
  PointIds points, cells;  // by vertex
  for_each_cell(*data, data->GetLines(), path.string(),
                [&](std::span<const vtkIdType> ids, vtkIdType line) {
                  points.insert(points.end(), ids.begin(), ids.end());
                  cells.resize(points.size(), data->GetNumberOfVerts() + line);
                  lines.offsets.push_back(points.size());
                });
  lines.positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data->GetPoint(points[i], &lines.positions[i].x);
  VertexAttributes attributes = attributes_of(*data, points);
  if (vtkDataArray* colors = cell_colors(*data, attributes))
    take_colors(*colors, cells, attributes);
  take_attributes(std::move(attributes), lines);
  return lines;
}

PointSet read_vtk_points(const std::filesystem::path& path) {
  const auto data = readers::read_vtk_data_set(path);
  const PointIds points = shown_points(*data);
  PointSet set;
  set.positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data->GetPoint(points[i], &set.positions[i].x);
  take_attributes(attributes_of(*data, points), set);
  return set;
}

void write_vtp(const std::filesystem::path& path, const TriangleMesh& mesh) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_points(mesh.positions));
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : mesh.triangles) {
    const vtkIdType ids[] = {a, b, c};
    cells->InsertNextCell(3, ids);
  }
  data->SetPolys(cells);
  if (!mesh.normals.empty())
    data->GetPointData()->SetNormals(to_array<vtkDoubleArray>("Normals", mesh.normals));
  if (!mesh.colors.empty())
    data->GetPointData()->AddArray(to_array<vtkFloatArray>("RGBA", mesh.colors));
  if (!mesh.importance.empty()) add_scalars("importance", mesh.importance, *data);
  for (const auto& [name, values] : mesh.scalars) add_scalars(name, values, *data);
  save(path, *data);
}

void write_vtp_lines(const std::filesystem::path& path, const LineSet& lines) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_points(lines.positions));
  vtkNew<vtkCellArray> cells;
  for (std::size_t line = 0; line < lines.line_count(); ++line) {
    const std::uint64_t points = lines.offsets[line + 1] - lines.offsets[line];
    if (points < 2) continue;  // VTK's writer crashes over a line without a segment
    cells->InsertNextCell(static_cast<int>(points));
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
      cells->InsertCellPoint(static_cast<vtkIdType>(i));
  }
  data->SetLines(cells);
  for (const auto& [name, values] : lines.scalars) add_scalars(name, values, *data);
  save(path, *data);
}

FormatRow read_by_vtk(std::string_view ending, std::string_view title) {
  return {.ending = ending,
          .title = title,
          .read_mesh = read_vtk_mesh,
          .read_lines = read_vtk_lines,
          .read_points = read_vtk_points};
}

}  // namespace

FormatRow vtp_format() {
  FormatRow row = read_by_vtk(".vtp", "VTK poly data");
  row.write_mesh = write_vtp;
  row.write_lines = write_vtp_lines;
  return row;
}

FormatRow vtu_format() { return read_by_vtk(".vtu", "VTK unstructured grid"); }
FormatRow legacy_vtk_format() { return read_by_vtk(".vtk", "legacy VTK"); }

}  // namespace pellucid::geometry
