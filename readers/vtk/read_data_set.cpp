// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <cstring>
#include <new>

#include "readers/vtk/cell_rules.h"
#include "readers/vtk/data_set_blocks.h"
#include "readers/vtk/vtk_type.h"

namespace pellucid::readers {
namespace {

/// The block's numbers in memory that VTK is to free.
void* numbers_of(const Block& block) {
  if (void* numbers = block.release()) return numbers;
  void* copy = std::malloc(block.bytes.size());  // another array has them
  if (!copy) throw std::bad_alloc();
  return std::memcpy(copy, block.bytes.data(), block.bytes.size());
}

vtkSmartPointer<vtkDataArray> array_of(const Block& block) {
  const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(vtk_type(block.type)));
  array->SetNumberOfComponents(int(block.components));
  if (!block.bytes.empty())
    array->SetVoidArray(numbers_of(block), vtkIdType(block.components * block.tuples), 0,
                        vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

template <class Array>
vtkSmartPointer<Array> integers_of(const Block& block) {
  using Value = typename Array::ValueType;
  const auto values = block.values<std::int64_t>();
  static_assert(sizeof(Value) == sizeof(values[0]));
  const auto array = vtkSmartPointer<Array>::New();
  if (!values.empty())
    array->SetArray(static_cast<Value*>(numbers_of(block)), vtkIdType(values.size()), 0,
                    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

struct Extent {
  int bounds[6];
  vtkIdType points = 0, cells = 0;  // cells: of all axes along which there are two points or more
};

/// An extent without values behind it is a claim that costs nothing. The same bound as where a file
/// is parsed: no compressor makes data smaller than that.
void refuse_absurd_extent(const Extent& extent, const Blocks& blocks) {
  constexpr double largest_compression = 8192;
  std::size_t bytes = 0;
  for (const Block& block : blocks.all()) bytes += block.bytes.size();
  if (double(extent.points) > largest_compression * double(bytes))
    throw BlockError(
        fmt::format("its extent has {} points, but it holds {} bytes", extent.points, bytes));
}

Extent extent_of(const Blocks& blocks) {
  Extent extent;
  const auto bounds = blocks.at("extent").values<std::int32_t>();
  if (bounds.size() != 6) throw BlockError("its extent is not six numbers");
  std::copy(bounds.begin(), bounds.end(), extent.bounds);
  extent.points = extent.cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const vtkIdType size = vtkIdType(bounds[2 * axis + 1]) - bounds[2 * axis] + 1;
    if (size < 1)
      throw BlockError(fmt::format("its extent has {} points along axis {}", size, axis));
    if (__builtin_mul_overflow(extent.points, size, &extent.points))
      throw BlockError("its extent is too large");
    extent.cells *= std::max<vtkIdType>(size - 1, 1);
  }
  refuse_absurd_extent(extent, blocks);
  return extent;
}

template <std::size_t N>
const double* doubles_of(const Blocks& blocks, std::string_view name) {
  const auto values = blocks.at(name).values<double>();
  if (values.size() != N) throw BlockError(fmt::format("its {} is not {} numbers", name, N));
  return values.data();
}

/// A data set, and how many values its arrays have to have.
struct Parts {
  vtkSmartPointer<vtkDataSet> data;
  vtkIdType points = 0, cells = 0;
};

Parts image_of(const Blocks& blocks) {
  Extent extent = extent_of(blocks);
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent.bounds);
  image->SetOrigin(doubles_of<3>(blocks, "origin"));
  image->SetSpacing(doubles_of<3>(blocks, "spacing"));
  image->SetDirectionMatrix(doubles_of<9>(blocks, "direction"));
  return {image, extent.points, extent.cells};
}

Parts rectilinear_of(const Blocks& blocks) {
  Extent extent = extent_of(blocks);
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetExtent(extent.bounds);
  const char* const names[] = {"x", "y", "z"};
  vtkSmartPointer<vtkDataArray> axes[3];
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = array_of(blocks.at(names[axis]));
    const vtkIdType size = vtkIdType(extent.bounds[2 * axis + 1]) - extent.bounds[2 * axis] + 1;
    if (axes[axis]->GetNumberOfTuples() != size || axes[axis]->GetNumberOfComponents() != 1)
      throw BlockError(fmt::format("axis {} does not have one coordinate per sample", names[axis]));
  }
  grid->SetXCoordinates(axes[0]);
  grid->SetYCoordinates(axes[1]);
  grid->SetZCoordinates(axes[2]);
  return {grid, extent.points, extent.cells};
}

/// Gives the data set its points, and returns their number.
vtkIdType add_points(const Blocks& blocks, vtkPointSet& data) {
  const Block& block = blocks.at("points");
  const bool is_real = block.type == NumberType::f32 || block.type == NumberType::f64;
  if (block.tuples > 0 && (block.components != 3 || !is_real))
    throw BlockError("its points are not three real numbers each");
  vtkNew<vtkPoints> points;
  if (block.tuples > 0) points->SetData(array_of(block));
  data.SetPoints(points);
  return vtkIdType(block.tuples);
}

Parts structured_of(const Blocks& blocks) {
  Extent extent = extent_of(blocks);
  const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetExtent(extent.bounds);
  if (const vtkIdType points = add_points(blocks, *grid); points != extent.points)
    throw BlockError(
        fmt::format("its extent has {} points, but it holds {}", extent.points, points));
  return {grid, extent.points, extent.cells};
}

CellGroup group_of(const Blocks& blocks, const std::string& name, vtkIdType points) {
  const CellGroup group{blocks.at(name + ".offsets").values<std::int64_t>(),
                        blocks.at(name + ".connectivity").values<std::int64_t>()};
  check_cells(group, points);
  return group;
}

vtkSmartPointer<vtkCellArray> cells_of(const Blocks& blocks, const std::string& name) {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(integers_of<vtkTypeInt64Array>(blocks.at(name + ".offsets")),
                 integers_of<vtkTypeInt64Array>(blocks.at(name + ".connectivity")));
  return cells;
}

Parts unstructured_of(const Blocks& blocks) {
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkIdType points = add_points(blocks, *grid);
  const CellGroup group = group_of(blocks, "cells", points);
  const Block& type_block = blocks.at("types");
  if (type_block.tuples == 0 && group.count() == 0) return {grid, points, 0};
  const auto types = type_block.values<std::uint8_t>();
  check_types(types, group);
  const Block *faces = blocks.find("faces"), *locations = blocks.find("face_locations");
  const std::span<const std::int64_t> none;
  check_polyhedra(types, faces ? faces->values<std::int64_t>() : none,
                  locations ? locations->values<std::int64_t>() : none, points);
  const vtkSmartPointer<vtkDataArray> type_array = array_of(type_block);
  grid->SetCells(vtkUnsignedCharArray::SafeDownCast(type_array), cells_of(blocks, "cells"),
                 locations ? integers_of<vtkIdTypeArray>(*locations).Get() : nullptr,
                 faces ? integers_of<vtkIdTypeArray>(*faces).Get() : nullptr);
  return {grid, points, vtkIdType(group.count())};
}

Parts poly_of(const Blocks& blocks) {
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType points = add_points(blocks, *data);
  vtkIdType cells = 0;
  for (const char* name : {"verts", "lines", "polys", "strips"})
    cells += vtkIdType(group_of(blocks, name, points).count());
  data->SetVerts(cells_of(blocks, "verts"));
  data->SetLines(cells_of(blocks, "lines"));
  data->SetPolys(cells_of(blocks, "polys"));
  data->SetStrips(cells_of(blocks, "strips"));
  return {data, points, cells};
}

Parts parts_of(const Blocks& blocks) {
  const std::string kind = blocks.text("kind");
  if (kind == "image") return image_of(blocks);
  if (kind == "rectilinear") return rectilinear_of(blocks);
  if (kind == "structured") return structured_of(blocks);
  if (kind == "unstructured") return unstructured_of(blocks);
  if (kind == "poly") return poly_of(blocks);
  throw BlockError(fmt::format("it holds data of an unknown kind '{}'", kind));
}

void set_active(vtkDataSetAttributes& arrays, std::span<const std::int32_t> active,
                const std::vector<vtkDataArray*>& by_number) {
  const auto array = [&](std::size_t role) -> vtkDataArray* {
    const auto number = std::size_t(active[role]);
    return active[role] >= 0 && number < by_number.size() ? by_number[number] : nullptr;
  };
  // VTK refuses an array with another number of components by itself, but prints that it does.
  const auto has_three = [](vtkDataArray* a) { return a && a->GetNumberOfComponents() == 3; };
  if (vtkDataArray* scalars = array(0)) arrays.SetScalars(scalars);
  if (vtkDataArray* vectors = array(1); has_three(vectors)) arrays.SetVectors(vectors);
  if (vtkDataArray* normals = array(2); has_three(normals)) arrays.SetNormals(normals);
  if (vtkDataArray* texture = array(3); texture && texture->GetNumberOfComponents() <= 3)
    arrays.SetTCoords(texture);
}

void add_attributes(const Blocks& blocks, const std::string& group, vtkIdType count,
                    vtkDataSetAttributes& arrays) {
  std::vector<vtkDataArray*> by_number;
  for (const Block& block : blocks.all()) {
    if (!block.name.starts_with(group + ':')) continue;
    const std::string name = block.name.substr(group.size() + 1);
    if (block.tuples != std::uint64_t(count))
      throw BlockError(fmt::format("array '{}' has {} values, but there are {} {}s", name,
                                   block.tuples, count, group));
    const auto array = array_of(block);
    if (!name.empty()) array->SetName(name.c_str());
    const int place = arrays.AddArray(array);
    by_number.push_back(arrays.GetArray(place));
  }
  const auto active = blocks.at(group + ".active").values<std::int32_t>();
  if (active.size() != 4) throw BlockError("its active arrays are not four numbers");
  set_active(arrays, active, by_number);
}

}  // namespace

vtkSmartPointer<vtkDataSet> data_set_of(const Blocks& blocks) {
  const Parts parts = parts_of(blocks);
  add_attributes(blocks, "point", parts.points, *parts.data->GetPointData());
  add_attributes(blocks, "cell", parts.cells, *parts.data->GetCellData());
  return parts.data;
}

}  // namespace pellucid::readers
