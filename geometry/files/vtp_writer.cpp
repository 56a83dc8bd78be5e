// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/vtp_writer.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "readers/vtk/vtk_messages.h"

namespace pellucid::geometry {
namespace {

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

}  // namespace

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

}  // namespace pellucid::geometry
