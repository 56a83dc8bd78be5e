// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/vector_array.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/options/lower_case.h"
#include "core/options/split.h"
#include "fields/files/array_list.h"
#include "fields/files/cell_average.h"

namespace pellucid::fields {
namespace {

constexpr std::string_view point_prefix = "point:", cell_prefix = "cell:";

/// The axis along which all points lie in one place, when it is the only one.
std::optional<int> flat_axis(vtkDataSet& data) {
  double bounds[6];
  data.GetBounds(bounds);
  std::optional<int> flat;
  for (int axis = 0; axis < 3; ++axis) {
    if (bounds[2 * axis] != bounds[2 * axis + 1]) continue;
    if (flat) return std::nullopt;
    flat = axis;
  }
  return flat;
}

/// What stands for a component that is nowhere but 0: "array=u,v,0".
constexpr std::string_view zero = "0";

/// One number of each of three arrays, or of an array's components; a part that is missing is 0.
struct Part {
  vtkDataArray* array = nullptr;
  int component = 0;
  bool is_zero = false;  // because that was asked for
};
using Parts = std::array<Part, 3>;

/// Finds vectors among the arrays of the points, or of the cells.
class Finder {
 public:
  Finder(vtkDataSetAttributes& arrays, std::optional<int> flat) : arrays_(arrays), flat_(flat) {}

  /// Those that the file calls its vectors.
  std::optional<Parts> active() const {
    vtkDataArray* vectors = arrays_.GetVectors();
    return vectors ? parts_of(vectors) : std::nullopt;
  }

  /// Arrays of so many components that may be velocities.
  std::vector<vtkDataArray*> candidates(int components) const {
    std::vector<vtkDataArray*> found;
    for (int i = 0; i < arrays_.GetNumberOfArrays(); ++i)
      if (vtkDataArray* array = arrays_.GetArray(i);
          array && array->GetNumberOfComponents() == components && !is_something_else(*array))
        found.push_back(array);
    return found;
  }

  std::optional<Parts> scalar(const std::string& name) const {
    vtkDataArray* array = arrays_.GetArray(name.c_str());
    if (!array || array->GetNumberOfComponents() != 1) return std::nullopt;
    return Parts{{{array, 0}}};
  }

  std::optional<Parts> by_name(const std::string& name) const {
    if (vtkDataArray* array = arrays_.GetArray(name.c_str())) return parts_of(array);
    const auto names = split(name, ',');
    if (names.size() != 3 && !(names.size() == 2 && flat_)) return std::nullopt;
    std::vector<Part> parts;
    for (const std::string_view one : names) {
      vtkDataArray* array = arrays_.GetArray(std::string(one).c_str());
      const bool is_scalar = array && array->GetNumberOfComponents() == 1;
      if (!is_scalar && (array || one != zero)) return std::nullopt;
      parts.push_back({array, 0, !array});
    }
    const bool any = std::ranges::any_of(parts, [](const Part& part) { return part.array; });
    return any ? std::optional(placed(parts)) : std::nullopt;
  }

  std::optional<Parts> parts_of(vtkDataArray* array) const {
    const int count = array->GetNumberOfComponents();
    if (count != 3 && !(count == 2 && flat_)) return std::nullopt;
    std::vector<Part> parts;
    for (int k = 0; k < count; ++k) parts.push_back({array, k});
    return placed(parts);
  }

 private:
  /// Colours are bytes; VTK's writers mark and name normals and texture coordinates.
  bool is_something_else(vtkDataArray& array) const {
    constexpr std::string_view names[] = {
        "normal", "normals", "texture coordinates", "texturecoordinates", "tcoords", "texcoords"};
    const std::string name = lower_case(array.GetName() ? array.GetName() : "");
    return array.GetDataType() == VTK_UNSIGNED_CHAR || array.GetDataType() == VTK_ID_TYPE ||
           &array == arrays_.GetNormals() || &array == arrays_.GetTCoords() ||
           std::ranges::find(names, name) != std::end(names);
  }

  /// Two parts belong to the axes along which the data are not flat.
  Parts placed(const std::vector<Part>& parts) const {
    Parts three;
    std::size_t next = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (parts.size() == 3 || int(axis) != *flat_) three[axis] = parts[next++];
    return three;
  }

  vtkDataSetAttributes& arrays_;
  std::optional<int> flat_;
};

/// "U", or "U,V,W", of which several may be one array, or 0.
std::string name_of(const Parts& parts) {
  std::string names;
  for (const Part& part : parts) {
    if (part.component > 0 || (!part.array && !part.is_zero)) continue;
    const char* name = part.array ? part.array->GetName() : zero.data();
    if (!names.empty()) names += ',';
    names += name ? name : "vectors";
  }
  return names;
}

/// "" where one of the arrays has no name.
std::string own_name(const Parts& parts) {
  for (const Part& part : parts)
    if (part.array && !part.array->GetName()) return {};
  return name_of(parts);
}

bool is_one_array(const Parts& parts) {
  for (int axis = 0; axis < 3; ++axis)
    if (const Part& part = parts[std::size_t(axis)];
        part.array != parts[0].array || part.component != axis)
      return false;
  return true;
}

vtkSmartPointer<vtkDataArray> joined(const Parts& parts, vtkIdType count) {
  bool is_single = true;
  for (const Part& part : parts) is_single &= !part.array || part.array->GetDataType() == VTK_FLOAT;
  vtkSmartPointer<vtkDataArray> vectors;
  if (is_single)
    vectors = vtkSmartPointer<vtkFloatArray>::New();
  else
    vectors = vtkSmartPointer<vtkDoubleArray>::New();
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(count);
  for (int axis = 0; axis < 3; ++axis)
    for (vtkIdType i = 0; i < count; ++i) {
      const Part& part = parts[std::size_t(axis)];
      vectors->SetComponent(i, axis, part.array ? part.array->GetComponent(i, part.component) : 0);
    }
  return vectors;
}

class Choice {
 public:
  Choice(vtkDataSet& data, const std::string& wanted, CellValues cells,
         const std::filesystem::path& path, Quantity quantity)
      : data_(data),
        wanted_(wanted),
        cells_(cells),
        path_(path),
        quantity_(quantity),
        flat_(flat_axis(data)) {}

  Vectors vectors() const {
    Vectors found = wanted_.empty() ? by_default() : by_name();
    found.quantity = quantity_;
    return found;
  }

 private:
  Finder of_points() const { return {*data_.GetPointData(), flat_}; }
  Finder of_cells() const { return {*data_.GetCellData(), flat_}; }
  bool takes_points() const { return cells_ == CellValues::averaged; }

  /// Those that the file calls so, wherever they are; else the only ones that may be velocities:
  /// those of one name at points and in cells are one. Three components come before two.
  Vectors by_default() const {
    if (takes_points())
      if (const auto parts = of_points().active()) return at_points(*parts);
    if (const auto parts = of_cells().active()) return in_cells(*parts);
    for (const int components : {3, 2}) {
      if (components == 2 && !flat_) break;
      std::vector<vtkDataArray*> points, cells = of_cells().candidates(components);
      if (takes_points()) points = of_points().candidates(components);
      std::erase_if(cells, [&](vtkDataArray* cell) { return has_name_of(points, *cell); });
      if (points.size() + cells.size() > 1) refuse();
      if (!points.empty()) return at_points(*of_points().parts_of(points.front()));
      if (!cells.empty()) return in_cells(*of_cells().parts_of(cells.front()));
    }
    refuse();
  }

  Vectors by_name() const {
    if (takes_points())
      if (const auto parts = find(of_points(), point_prefix)) return at_points(*parts);
    if (const auto parts = find(of_cells(), cell_prefix)) return in_cells(*parts);
    refuse();
  }

  static bool has_name_of(const std::vector<vtkDataArray*>& arrays, vtkDataArray& other) {
    return std::ranges::any_of(arrays, [&](vtkDataArray* array) {
      return array->GetName() && other.GetName() &&
             std::string_view(array->GetName()) == other.GetName();
    });
  }

  std::optional<Parts> named(const Finder& finder, const std::string& name) const {
    return quantity_ == Quantity::scalar ? finder.scalar(name) : finder.by_name(name);
  }
  std::optional<Parts> find(const Finder& finder, std::string_view prefix) const {
    if (auto parts = named(finder, wanted_)) return parts;
    return wanted_.starts_with(prefix) ? named(finder, wanted_.substr(prefix.size()))
                                       : std::nullopt;
  }

  vtkSmartPointer<vtkDataArray> values(const Parts& parts, vtkIdType count,
                                       std::string_view what) const {
    for (const Part& part : parts)
      if (part.array && part.array->GetNumberOfTuples() != count)
        throw InputError(fmt::format("{}: array '{}' has {} values, but there are {} {}",
                                     path_.string(), name_of(parts),
                                     part.array->GetNumberOfTuples(), count, what));
    return is_one_array(parts) ? vtkSmartPointer<vtkDataArray>(parts[0].array)
                               : joined(parts, count);
  }

  Vectors at_points(const Parts& parts) const {
    return {values(parts, data_.GetNumberOfPoints(), "points"), false, false, own_name(parts),
            name_of(parts)};
  }

  /// Their name says where they are, so that others of it at points are not meant later.
  Vectors in_cells(const Parts& parts) const {
    auto vectors = values(parts, data_.GetNumberOfCells(), "cells");
    const std::string name = name_of(parts), own = own_name(parts);
    const std::string placed = own.empty() ? own : std::string(cell_prefix) + own;
    if (cells_ == CellValues::constant) return {vectors, true, false, placed, name};
    return {averaged_to_points(data_, *vectors), false, true, placed,
            name + " of the cells, averaged to points"};
  }

  [[noreturn]] void refuse() const {
    if (quantity_ == Quantity::scalar)
      throw InputError(fmt::format(
          "{}: no scalar '{}'; accepted: an array of one component{}; "
          "arrays: {}",
          path_.string(), wanted_, takes_points() ? "" : " of the cells", describe_arrays(data_)));
    const std::string way =
        flat_ ? "array=NAME, array=U,V or array=U,V,W" : "array=NAME, array=U,V,W or array=U,V,0";
    const std::string problem =
        wanted_.empty() ? "which vectors?" : fmt::format("array={}: no such vectors;", wanted_);
    throw InputError(fmt::format(
        "{}: {} accepted: {}, of three components together{}; arrays: {}", path_.string(), problem,
        way, cells_ == CellValues::constant ? ", of the cells" : "", describe_arrays(data_)));
  }

  vtkDataSet& data_;
  const std::string& wanted_;
  CellValues cells_;
  const std::filesystem::path& path_;
  Quantity quantity_;
  std::optional<int> flat_;
};

}  // namespace

Vectors pick_vectors(vtkDataSet& data, const std::string& wanted, CellValues cells,
                     const std::filesystem::path& path, Quantity quantity) {
  return Choice(data, wanted, cells, path, quantity).vectors();
}

}  // namespace pellucid::fields
