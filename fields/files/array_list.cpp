// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/array_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/range_text.h"

namespace pellucid::fields {
namespace {

/// A number, or the length of several.
double size_of_tuple(vtkDataArray& array, vtkIdType i) {
  const int count = array.GetNumberOfComponents();
  if (count == 1) return array.GetComponent(i, 0);
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += std::pow(array.GetComponent(i, k), 2);
  return std::sqrt(sum);
}

std::string range_of(vtkDataArray& array) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
    const double size = size_of_tuple(array, i);
    if (!std::isfinite(size)) continue;
    low = std::min(low, size), high = std::max(high, size);
  }
  return low <= high ? range_text(low, high) : "no finite value";
}

std::string describe(vtkDataArray& array, const char* name, std::string_view kind) {
  const int count = array.GetNumberOfComponents();
  return fmt::format("{} ({}, {} component{}, {}{})", name, kind, count, count == 1 ? "" : "s",
                     count == 1 ? "" : "lengths ", range_of(array));
}

void append(vtkFieldData& arrays, std::string_view kind, std::vector<std::string>& parts) {
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
    if (vtkDataArray* array = arrays.GetArray(i); array && arrays.GetArrayName(i))
      parts.push_back(describe(*array, arrays.GetArrayName(i), kind));
}

}  // namespace

std::string describe_arrays(vtkDataSet& data) {
  std::vector<std::string> parts;
  append(*data.GetPointData(), "point", parts);
  append(*data.GetCellData(), "cell", parts);
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace pellucid::fields
