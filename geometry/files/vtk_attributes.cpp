// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/vtk_attributes.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "geometry/files/color_names.h"
#include "geometry/files/component_suffix.h"

namespace pellucid::geometry {
namespace {

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

bool in_unit_interval(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double x) { return x >= 0 && x <= 1; });
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

bool is_scalar(vtkDataArray* array) { return array && array->GetNumberOfComponents() == 1; }

/// Whether there is a colour, of one array or of three, so that scalars called as its channels are
/// channels.
bool has_colors(vtkDataSetAttributes& arrays) {
  return find_colors(arrays) ||
         (is_scalar(arrays.GetArray("red")) && is_scalar(arrays.GetArray("green")) &&
          is_scalar(arrays.GetArray("blue")));
}

/// Scalars keep their name, others have one for each component; of bytes, the scalars red, green,
/// blue and alpha count in 255ths, where they are channels.
void take_array(vtkDataArray& array, const PointIds& points, bool channels,
                VertexAttributes& attributes) {
  const std::string name = array.GetName() ? array.GetName() : "unnamed";
  const int components = array.GetNumberOfComponents();
  const bool is_channel =
      channels && (name == "red" || name == "green" || name == "blue" || name == "alpha");
  if (components == 1)
    return take_column(array, points, name, 0, is_channel ? vtk_color_unit(array) : 1, attributes);
  for (int c = 0; c < components; ++c)
    take_column(array, points, name + component_suffix(std::size_t(c), std::size_t(components)), c,
                1, attributes);
}

}  // namespace

double vtk_color_unit(vtkDataArray& array) {
  return array.GetDataType() == VTK_UNSIGNED_CHAR ? 255 : 1;
}

void take_vtk_colors(vtkDataArray& array, const PointIds& tuples, VertexAttributes& attributes) {
  static const char* const rgba[] = {"red", "green", "blue", "alpha"};
  for (int c = 0; c < array.GetNumberOfComponents(); ++c)
    take_column(array, tuples, rgba[c], c, vtk_color_unit(array), attributes);
}

VertexAttributes vtk_attributes(vtkDataSet& data, const PointIds& points) {
  VertexAttributes attributes;
  vtkPointData& arrays = *data.GetPointData();
  vtkDataArray* const colors = find_colors(arrays);
  const bool channels = has_colors(arrays) || find_colors(*data.GetCellData());
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k); array && array != arrays.GetNormals() &&
                                                  array != colors &&
                                                  array != data.GetPointGhostArray())
      take_array(*array, points, channels, attributes);
  if (colors) take_vtk_colors(*colors, points, attributes);
  if (vtkDataArray* normals = arrays.GetNormals())
    for (int c = 0; c < 3; ++c)
      take_column(*normals, points, std::string("n") + "xyz"[c], c, 1, attributes);
  return attributes;
}

VertexAttributes vtk_cell_scalars(vtkDataSet& data, const PointIds& cells) {
  VertexAttributes scalars;
  vtkCellData& arrays = *data.GetCellData();
  const vtkDataArray* const colors = find_colors(arrays);
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = arrays.GetArray(k);
        array && array != colors && array != data.GetCellGhostArray() &&
        array->GetNumberOfTuples() == data.GetNumberOfCells())
      take_array(*array, cells, has_colors(arrays), scalars);
  return scalars;
}

void take_vtk_attributes(VertexAttributes attributes, Vertices& vertices, bool colored) {
  const auto keep = [&](const char* name, const std::string& why) {
    auto scalar = attributes.extract(name);
    vertices.remarks.push_back(fmt::format("'{}' {}: it is a scalar", name, why));
    return scalar;
  };
  VertexAttributes scalars;
  if (!colored && !has_rgb(attributes) && attributes.contains("alpha"))
    scalars.insert(keep("alpha", "has no red, green and blue beside it and is no opacity"));
  if (attributes.contains("importance") && !in_unit_interval(attributes["importance"]))
    scalars.insert(keep("importance", "goes beyond 0 … 1 and is no importance"));
  take_attributes(std::move(attributes), vertices);
  vertices.scalars.merge(scalars);
}

void remark_greys(vtkDataSet& data, Vertices& vertices) {
  if (!vertices.colors.empty()) return;
  const auto look = [&](vtkDataSetAttributes& arrays, const vtkDataArray* marks) {
    vtkDataArray* const active = arrays.GetScalars();
    if (!active || active == marks || active->GetDataType() != VTK_UNSIGNED_CHAR ||
        active->GetNumberOfComponents() > 2)
      return;
    const char* const name = active->GetName() ? active->GetName() : "unnamed";
    vertices.remarks.push_back(fmt::format(
        "'{}' is of bytes, which VTK draws as greys: here it is read as scalars", name));
  };
  look(*data.GetPointData(), data.GetPointGhostArray());
  look(*data.GetCellData(), data.GetCellGhostArray());
}

vtkDataArray* vtk_cell_colors(vtkDataSet& data, const VertexAttributes& of_points) {
  vtkDataArray* colors = find_colors(*data.GetCellData());
  const bool usable = colors && colors->GetNumberOfTuples() == data.GetNumberOfCells();
  return usable && !has_rgb(of_points) ? colors : nullptr;
}

}  // namespace pellucid::geometry
