// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/vector_array.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <array>
#include <optional>
#include <vector>

#include "core/error.h"
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

/// One number of each of three arrays, or of an array's components; a part that is missing is 0.
struct Part {
  vtkDataArray* array = nullptr;
  int component = 0;
};
using Parts = std::array<Part, 3>;

/// Finds vectors among the arrays of the points, or of the cells.
class Finder {
 public:
  Finder(vtkDataSetAttributes& arrays, std::optional<int> flat) : arrays_(arrays), flat_(flat) {}

  /// The active vectors, or the only ones; three components before two.
  std::optional<Parts> by_default() const {
    if (vtkDataArray* active = arrays_.GetVectors()) return parts_of(active);
    if (vtkDataArray* only = only_one(3)) return parts_of(only);
    if (vtkDataArray* only = flat_ ? only_one(2) : nullptr) return parts_of(only);
    return std::nullopt;
  }

  std::optional<Parts> by_name(const std::string& name) const {
    if (vtkDataArray* array = arrays_.GetArray(name.c_str())) return parts_of(array);
    const auto names = split(name, ',');
    if (names.size() != 3 && !(names.size() == 2 && flat_)) return std::nullopt;
    std::vector<Part> parts;
    for (const std::string_view one : names) {
      vtkDataArray* array = arrays_.GetArray(std::string(one).c_str());
      if (!array || array->GetNumberOfComponents() != 1) return std::nullopt;
      parts.push_back({array, 0});
    }
    return placed(parts);
  }

 private:
  vtkDataArray* only_one(int components) const {
    vtkDataArray* only = nullptr;
    for (int i = 0; i < arrays_.GetNumberOfArrays(); ++i) {
      vtkDataArray* array = arrays_.GetArray(i);
      if (!array || array->GetNumberOfComponents() != components) continue;
      if (only) return nullptr;
      only = array;
    }
    return only;
  }

  std::optional<Parts> parts_of(vtkDataArray* array) const {
    const int count = array->GetNumberOfComponents();
    if (count != 3 && !(count == 2 && flat_)) return std::nullopt;
    std::vector<Part> parts;
    for (int k = 0; k < count; ++k) parts.push_back({array, k});
    return placed(parts);
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

/// "U", or "U,V,W", of which several may be one array.
std::string name_of(const Parts& parts) {
  std::string names;
  for (const Part& part : parts) {
    if (!part.array || part.component > 0) continue;
    const char* name = const_cast<vtkDataArray*>(part.array)->GetName();
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
    if (const auto& [array, component] = parts[std::size_t(axis)];
        array != parts[0].array || component != axis)
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
      const auto& [array, component] = parts[std::size_t(axis)];
      vectors->SetComponent(i, axis, array ? array->GetComponent(i, component) : 0);
    }
  return vectors;
}

class Choice {
 public:
  Choice(vtkDataSet& data, const std::string& wanted, CellValues cells,
         const std::filesystem::path& path)
      : data_(data), wanted_(wanted), cells_(cells), path_(path), flat_(flat_axis(data)) {}

  Vectors vectors() const {
    if (cells_ == CellValues::averaged)
      if (const auto parts = find(*data_.GetPointData(), point_prefix))
        return {values(*parts, data_.GetNumberOfPoints(), "points"), false, false, own_name(*parts),
                name_of(*parts)};
    if (const auto parts = find(*data_.GetCellData(), cell_prefix)) return of_cells(*parts);
    refuse();
  }

 private:
  std::optional<Parts> find(vtkDataSetAttributes& arrays, std::string_view prefix) const {
    const Finder finder(arrays, flat_);
    if (wanted_.empty() && is_unclear(arrays)) refuse();
    if (wanted_.empty()) return finder.by_default();
    if (auto parts = finder.by_name(wanted_)) return parts;
    return wanted_.starts_with(prefix) ? finder.by_name(wanted_.substr(prefix.size()))
                                       : std::nullopt;
  }

  /// Several arrays could be meant, and none is active: those of cells are no way out.
  static bool is_unclear(vtkDataSetAttributes& arrays) {
    int count = 0;
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
      count += arrays.GetArray(i) && arrays.GetArray(i)->GetNumberOfComponents() == 3;
    return count > 1 && !arrays.GetVectors();
  }

  vtkSmartPointer<vtkDataArray> values(const Parts& parts, vtkIdType count,
                                       std::string_view what) const {
    for (const Part& part : parts)
      if (part.array && part.array->GetNumberOfTuples() != count)
        throw InputError(fmt::format("{}: array '{}' has {} vectors, but there are {} {}",
                                     path_.string(), name_of(parts),
                                     part.array->GetNumberOfTuples(), count, what));
    return is_one_array(parts) ? vtkSmartPointer<vtkDataArray>(parts[0].array)
                               : joined(parts, count);
  }

  Vectors of_cells(const Parts& parts) const {
    auto vectors = values(parts, data_.GetNumberOfCells(), "cells");
    const std::string name = name_of(parts);
    if (cells_ == CellValues::constant)
      return {vectors, true, false, own_name(parts), name + ", constant in cells"};
    return {averaged_to_points(data_, *vectors), false, true, own_name(parts),
            name + " of the cells, averaged to points"};
  }

  [[noreturn]] void refuse() const {
    const std::string way =
        flat_ ? "array=NAME, array=U,V or array=U,V,W" : "array=NAME or array=U,V,W";
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
  std::optional<int> flat_;
};

}  // namespace

Vectors pick_vectors(vtkDataSet& data, const std::string& wanted, CellValues cells,
                     const std::filesystem::path& path) {
  return Choice(data, wanted, cells, path).vectors();
}

}  // namespace pellucid::fields
