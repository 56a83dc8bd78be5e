// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include <cmath>
#include <map>

#include "app/info/inspect.h"
#include "core/error.h"
#include "fields/files/meta_image_data.h"
#include "fields/readers/file_field.h"
#include "geometry/files/mesh_formats.h"
#include "readers/vtk/vtk_file.h"

namespace pellucid::app {
namespace {

template <class Number>
void collect(const Number* numbers, std::size_t tuples, std::size_t components,
             RangeCollector& ranges) {
  for (std::size_t i = 0; i < tuples; ++i)
    for (std::size_t c = 0; c < components; ++c) ranges.add(c, double(numbers[i * components + c]));
}

ArrayContents contents_of(vtkDataArray& array, std::string_view at) {
  const auto tuples = std::size_t(array.GetNumberOfTuples());
  const auto components = std::size_t(array.GetNumberOfComponents());
  RangeCollector ranges(components);
  switch (array.GetDataType()) {
    vtkTemplateMacro(
        collect(static_cast<const VTK_TT*>(array.GetVoidPointer(0)), tuples, components, ranges));
  }
  return ranges.contents(array.GetName() ? array.GetName() : "", std::string(at),
                         array.GetDataTypeAsString(), tuples);
}

void add_arrays(vtkDataSetAttributes& arrays, std::string_view at, FileContents& contents) {
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k))
      contents.arrays.push_back(contents_of(*array, at));
}

std::string kind_of(const vtkDataSet& data) {
  switch (const_cast<vtkDataSet&>(data).GetDataObjectType()) {
    case VTK_IMAGE_DATA:
    case VTK_STRUCTURED_POINTS:
      return "image";
    case VTK_RECTILINEAR_GRID:
      return "rectilinear grid";
    case VTK_STRUCTURED_GRID:
      return "structured grid";
    case VTK_POLY_DATA:
      return "poly data";
    default:
      return "unstructured grid";
  }
}

/// Cells by VTK's name of their type, where they are not all of one.
void count_cells(vtkDataSet& data, FileContents& contents) {
  contents.counts = {{"points", std::uint64_t(data.GetNumberOfPoints())},
                     {"cells", std::uint64_t(data.GetNumberOfCells())}};
  if (contents.kind != "unstructured grid" && contents.kind != "poly data") return;
  std::map<int, std::uint64_t> by_type;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) ++by_type[data.GetCellType(i)];
  nlohmann::ordered_json& types = contents.more["cell types"];
  for (const auto& [type, count] : by_type)
    types[vtkCellTypes::GetClassNameFromTypeId(type)] = count;
}

void add_lattice(vtkDataSet& data, FileContents& contents) {
  int size[3] = {0, 0, 0};
  if (auto* image = vtkImageData::SafeDownCast(&data)) {
    image->GetDimensions(size);
    const double *origin = image->GetOrigin(), *spacing = image->GetSpacing();
    contents.more["origin"] = {origin[0], origin[1], origin[2]};
    contents.more["spacing"] = {spacing[0], spacing[1], spacing[2]};
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(&data)) grid->GetDimensions(size);
  if (auto* grid = vtkStructuredGrid::SafeDownCast(&data)) grid->GetDimensions(size);
  if (size[0] > 0) contents.more["dimensions"] = {size[0], size[1], size[2]};
}

/// Points of unstructured data may be anywhere; bounds are of those that have a place.
void count_lost_points(vtkDataSet& data, FileContents& contents) {
  if (!vtkPointSet::SafeDownCast(&data)) return;
  std::uint64_t lost = 0;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    double x[3];
    data.GetPoint(i, x);
    lost += std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]) ? 0 : 1;
  }
  if (lost > 0) contents.more["points not finite"] = lost;
}

std::string title_of(const std::filesystem::path& path) {
  if (const auto* row = geometry::mesh_format(path)) return std::string(row->title);
  if (const auto* row = fields::file_format(path.string())) return std::string(row->title);
  return "VTK";
}

/// Returns the first time of a file. Where that cannot be read, as of cases whose first one is
/// written by hand, it is the last, and `remark` says why.
readers::VtkTime first_readable(const std::filesystem::path& path, std::string& remark) {
  const auto read = [&](const char* time) {
    return readers::read_vtk_file(path, {}, time).front();
  };
  std::string why;
  try {
    return read("first");
  } catch (const InputError& error) {
    why = error.what();
  }
  try {
    if (readers::VtkTime last = read("last"); last.of.size() > 1) {
      remark = fmt::format("told of the last time; the first is not read: {}", why);
      return last;
    }
  } catch (const InputError&) {  // the first complaint is the one that counts
  }
  throw InputError(why);
}

FileContents inspect_data_set(vtkDataSet& data, const std::filesystem::path& path) {
  FileContents contents;
  contents.kind = kind_of(data);
  contents.title = title_of(path);
  double box[6];
  data.GetBounds(box);
  contents.bounds = Box3{{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
  count_cells(data, contents);
  count_lost_points(data, contents);
  add_lattice(data, contents);
  add_arrays(*data.GetPointData(), "point", contents);
  add_arrays(*data.GetCellData(), "cell", contents);
  return contents;
}

}  // namespace

FileContents inspect_vtk(const std::filesystem::path& path) {
  std::string remark;
  const readers::VtkTime read = first_readable(path, remark);
  FileContents contents = inspect_data_set(*read.data, path);
  contents.times = read.of;
  if (!remark.empty()) contents.more["remarks"] = {remark};
  if (!read.left_out.empty()) contents.more["left out"] = read.left_out;
  return contents;
}

FileContents inspect_meta_image(const std::filesystem::path& path) {
  return inspect_data_set(*fields::data_set_of(fields::read_meta_image(path)), path);
}

}  // namespace pellucid::app
