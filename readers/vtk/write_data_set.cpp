// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include "readers/vtk/data_set_blocks.h"

namespace pellucid::readers {
namespace {

/// By size and sign, since several of VTK's types are the same.
NumberType type_of(vtkDataArray& array) {
  const int type = array.GetDataType();
  if (type == VTK_FLOAT) return NumberType::f32;
  if (type == VTK_DOUBLE) return NumberType::f64;
  const bool is_unsigned = type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ||
                           type == VTK_UNSIGNED_INT || type == VTK_UNSIGNED_LONG ||
                           type == VTK_UNSIGNED_LONG_LONG;
  switch (array.GetDataTypeSize()) {
    case 1:
      return is_unsigned ? NumberType::u8 : NumberType::i8;
    case 2:
      return is_unsigned ? NumberType::u16 : NumberType::i16;
    case 4:
      return is_unsigned ? NumberType::u32 : NumberType::i32;
    default:
      return is_unsigned ? NumberType::u64 : NumberType::i64;
  }
}

void write_array(const std::string& name, vtkDataArray* array, BlockWriter& out,
                 Numbers use = Numbers::kept) {
  if (!array) return out.add(name, NumberType::f64, 1, 0, nullptr);
  vtkNew<vtkUnsignedCharArray> bytes;
  if (array->GetDataType() == VTK_BIT) {
    bytes->DeepCopy(array);
    array = bytes;
  }
  const auto components = std::uint32_t(array->GetNumberOfComponents());
  const auto tuples = std::uint64_t(array->GetNumberOfTuples());
  if (use == Numbers::for_once)
    out.add_and_forget(name, type_of(*array), components, tuples, array->GetVoidPointer(0));
  else
    out.add(name, type_of(*array), components, tuples, array->GetVoidPointer(0));
}

/// Whether nothing but the data set has the array, and no other array of it has the same numbers.
bool is_alone(vtkDataArray& array, vtkDataSet& data) {
  int users = 0;
  for (vtkDataSetAttributes* arrays : {static_cast<vtkDataSetAttributes*>(data.GetPointData()),
                                       static_cast<vtkDataSetAttributes*>(data.GetCellData())})
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      if (vtkDataArray* other = arrays->GetArray(i))
        users += other->GetVoidPointer(0) == array.GetVoidPointer(0);
  return users == 1 && array.GetReferenceCount() == 1;
}

void write_cells(const std::string& group, vtkCellArray* cells, BlockWriter& out) {
  vtkNew<vtkCellArray> none;
  if (!cells) cells = none;
  cells->ConvertTo64BitStorage();
  write_array(group + ".offsets", cells->GetOffsetsArray(), out);
  write_array(group + ".connectivity", cells->GetConnectivityArray(), out);
}

void write_attributes(const std::string& group, vtkDataSetAttributes& arrays, vtkDataSet& data,
                      Numbers use, BlockWriter& out) {
  std::int32_t active[4] = {-1, -1, -1, -1}, number = 0;
  const vtkAbstractArray* special[4] = {arrays.GetScalars(), arrays.GetVectors(),
                                        arrays.GetNormals(), arrays.GetTCoords()};
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = arrays.GetArray(i);
    if (!array) continue;  // texts
    const char* name = array->GetName();
    write_array(fmt::format("{}:{}", group, name ? name : ""), array, out,
                is_alone(*array, data) ? use : Numbers::kept);
    for (int k = 0; k < 4; ++k)
      if (special[k] == array) active[k] = number;
    ++number;
  }
  out.add(group + ".active", std::span<const std::int32_t>(active));
}

template <class Grid>
void write_extent(Grid& grid, BlockWriter& out) {
  out.add("extent", std::span<const int>(grid.GetExtent(), 6));
}

void write_image(vtkImageData& image, BlockWriter& out) {
  write_extent(image, out);
  out.add("origin", std::span<const double>(image.GetOrigin(), 3));
  out.add("spacing", std::span<const double>(image.GetSpacing(), 3));
  out.add("direction", std::span<const double>(image.GetDirectionMatrix()->GetData(), 9));
}

void write_rectilinear(vtkRectilinearGrid& grid, BlockWriter& out) {
  write_extent(grid, out);
  write_array("x", grid.GetXCoordinates(), out);
  write_array("y", grid.GetYCoordinates(), out);
  write_array("z", grid.GetZCoordinates(), out);
}

void write_points(vtkPointSet& data, BlockWriter& out) {
  write_array("points", data.GetPoints() ? data.GetPoints()->GetData() : nullptr, out);
}

/// Polyhedra's faces, one cell's after the other's, each cell as its number of faces and of each
/// face its number of points and these; and where a cell's begin, -1 for other cells.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
void write_faces(vtkUnstructuredGrid& grid, BlockWriter& out) {
  if (!grid.GetFaces()) return;
  write_array("faces", grid.GetFaces(), out);
  write_array("face_locations", grid.GetFaceLocations(), out);
}
#else
void write_faces(vtkUnstructuredGrid& grid, BlockWriter& out) {
  if (!grid.GetPolyhedronFaces()) return;
  const vtkNew<vtkIdTypeArray> faces, locations;
  const vtkNew<vtkIdList> of_cell;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    const bool has_faces = grid.GetCellType(cell) == VTK_POLYHEDRON;
    locations->InsertNextValue(has_faces ? faces->GetNumberOfValues() : -1);
    if (!has_faces) continue;
    grid.GetFaceStream(cell, of_cell);
    for (vtkIdType i = 0; i < of_cell->GetNumberOfIds(); ++i)
      faces->InsertNextValue(of_cell->GetId(i));
  }
  write_array("faces", faces, out);
  write_array("face_locations", locations, out);
}
#endif

void write_unstructured(vtkUnstructuredGrid& grid, BlockWriter& out) {
  write_points(grid, out);
  write_array("types", grid.GetCellTypesArray(), out);
  write_cells("cells", grid.GetCells(), out);
  write_faces(grid, out);
}

void write_poly(vtkPolyData& data, BlockWriter& out) {
  write_points(data, out);
  write_cells("verts", data.GetVerts(), out);
  write_cells("lines", data.GetLines(), out);
  write_cells("polys", data.GetPolys(), out);
  write_cells("strips", data.GetStrips(), out);
}

void write_structure(vtkDataSet& data, BlockWriter& out) {
  if (auto* image = vtkImageData::SafeDownCast(&data)) {
    out.add_text("kind", "image");
    write_image(*image, out);
  } else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) {
    out.add_text("kind", "rectilinear");
    write_rectilinear(*rectilinear, out);
  } else if (auto* structured = vtkStructuredGrid::SafeDownCast(&data)) {
    out.add_text("kind", "structured");
    write_extent(*structured, out);
    write_points(*structured, out);
  } else if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(&data)) {
    out.add_text("kind", "unstructured");
    write_unstructured(*unstructured, out);
  } else if (auto* poly = vtkPolyData::SafeDownCast(&data)) {
    out.add_text("kind", "poly");
    write_poly(*poly, out);
  } else {
    throw BlockError(fmt::format("it holds a {}", data.GetClassName()));
  }
}

}  // namespace

void write_data_set(vtkDataSet& data, BlockWriter& out, Numbers use) {
  write_structure(data, out);
  write_attributes("point", *data.GetPointData(), data, use, out);
  write_attributes("cell", *data.GetCellData(), data, use, out);
}

}  // namespace pellucid::readers
