// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's files: polygons and polylines of .vtp and legacy .vtk, the cells of an unstructured grid.

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
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

#include <numeric>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_formats.h"
#include "readers/vtk/vtk_file.h"
#include "readers/vtk/vtk_messages.h"

namespace pellucid::geometry {
namespace {

/// Polygons and lines as they are; of other data the lines, and the faces that bound its cells.
vtkSmartPointer<vtkPolyData> load_cells(const std::filesystem::path& path) {
  const auto data = readers::read_vtk_data_set(path);
  if (const auto polygons = vtkPolyData::SafeDownCast(data)) return polygons;
  const readers::VtkMessages messages;
  vtkNew<vtkGeometryFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

using PointIds = std::vector<vtkIdType>;

void take_column(vtkDataArray& array, const PointIds& points, const std::string& name,
                 int component, double scale, VertexAttributes& attributes) {
  std::vector<double>& column = attributes[name];
  column.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    column[i] = array.GetComponent(points[i], component) / scale;
}

/// Scalars keep their name; a 3- or 4-component array that is named like a colour is one; other
/// vectors give NAME_x, NAME_y, NAME_z.
void take_array(vtkDataArray& array, const PointIds& points, VertexAttributes& attributes) {
  const std::string name = array.GetName() ? array.GetName() : "unnamed";
  const int components = array.GetNumberOfComponents();
  const double scale = array.GetDataType() == VTK_UNSIGNED_CHAR ? 255 : 1;
  static const char* const rgba[] = {"red", "green", "blue", "alpha"};
  static const char* const axes[] = {"_x", "_y", "_z", "_w"};
  const bool is_color = components >= 3 && components <= 4 &&
                        (name == "RGB" || name == "RGBA" || name == "Colors" || name == "color");
  const bool is_channel = name == "red" || name == "green" || name == "blue" || name == "alpha";
  if (components == 1)
    return take_column(array, points, name, 0, is_channel ? scale : 1, attributes);
  for (int c = 0; c < std::min(components, 4); ++c)
    take_column(array, points, is_color ? rgba[c] : name + axes[c], c, is_color ? scale : 1,
                attributes);
}

/// The points' attributes, in the order of `points`.
VertexAttributes attributes_of(vtkDataSet& data, const PointIds& points) {
  VertexAttributes attributes;
  vtkPointData& arrays = *data.GetPointData();
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k); array && array != arrays.GetNormals())
      take_array(*array, points, attributes);
  if (vtkDataArray* normals = arrays.GetNormals())
    for (int c = 0; c < 3; ++c)
      take_column(*normals, points, std::string("n") + "xyz"[c], c, 1, attributes);
  return attributes;
}

PointIds every_point(vtkDataSet& data) {
  PointIds points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  std::iota(points.begin(), points.end(), vtkIdType(0));
  return points;
}

/// The points of all polylines one after another; `offsets` is where each line ends.
PointIds joined_points(vtkCellArray* cells, std::vector<std::uint64_t>& offsets) {
  PointIds points;
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    points.insert(points.end(), ids, ids + count);
    offsets.push_back(points.size());
  }
  return points;
}

void take_positions(vtkDataSet& data, Vertices& vertices) {
  vertices.positions.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    data.GetPoint(i, &vertices.positions[static_cast<std::size_t>(i)].x);
}

void add_fans(vtkCellArray* cells, TriangleMesh& mesh) {
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    for (vtkIdType k = 2; k < count; ++k)
      mesh.triangles.push_back(
          {std::uint32_t(ids[0]), std::uint32_t(ids[k - 1]), std::uint32_t(ids[k])});
  }
}

void add_strips(vtkCellArray* cells, TriangleMesh& mesh) {
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    for (vtkIdType k = 2; k < count; ++k) {
      const bool odd = k % 2 == 1;
      mesh.triangles.push_back({std::uint32_t(ids[k - 2 + odd]), std::uint32_t(ids[k - 1 - odd]),
                                std::uint32_t(ids[k])});
    }
  }
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
  add_fans(data->GetPolys(), mesh);
  add_strips(data->GetStrips(), mesh);
  take_attributes(attributes_of(*data, every_point(*data)), mesh);
  return mesh;
}

LineSet read_vtk_lines(const std::filesystem::path& path) {
  const auto data = load_cells(path);
  LineSet lines;
  const PointIds points = joined_points(data->GetLines(), lines.offsets);
  lines.positions.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data->GetPoint(points[i], &lines.positions[i].x);
  take_attributes(attributes_of(*data, points), lines);
  return lines;
}

PointSet read_vtk_points(const std::filesystem::path& path) {
  const auto data = readers::read_vtk_data_set(path);
  PointSet points;
  take_positions(*data, points);
  take_attributes(attributes_of(*data, every_point(*data)), points);
  return points;
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
