// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/vector_array.h"

#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include "core/error.h"

namespace pellucid::fields {
namespace {

std::string vector_names(vtkPointData* arrays) {
  std::string names;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    const vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetNumberOfComponents() == 3 && arrays->GetArrayName(i))
      names += (names.empty() ? "" : ", ") + std::string(arrays->GetArrayName(i));
  }
  return names.empty() ? "none" : names;
}

vtkDataArray* only_vectors(vtkPointData* arrays) {
  vtkDataArray* only = nullptr;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = arrays->GetArray(i);
    if (!array || array->GetNumberOfComponents() != 3) continue;
    if (only) return nullptr;
    only = array;
  }
  return only;
}

}  // namespace

vtkDataArray* pick_vectors(vtkDataSet* data, const std::string& name,
                           const std::filesystem::path& path) {
  vtkPointData* arrays = data->GetPointData();
  vtkDataArray* vectors = name.empty() ? arrays->GetVectors() : arrays->GetArray(name.c_str());
  if (name.empty() && !vectors) vectors = only_vectors(arrays);
  const std::string names = vector_names(arrays);
  if (!vectors && name.empty())
    throw InputError(
        fmt::format("{}: which vectors? array=NAME; point arrays of three components: "
                    "{}",
                    path.string(), names));
  if (!vectors || vectors->GetNumberOfComponents() != 3)
    throw InputError(
        fmt::format("{}: array={}: no such vectors; point arrays of three components: "
                    "{}",
                    path.string(), name, names));
  if (vectors->GetNumberOfTuples() != data->GetNumberOfPoints())
    throw InputError(fmt::format("{}: array '{}' has {} vectors, but there are {} points",
                                 path.string(), vectors->GetName() ? vectors->GetName() : "",
                                 vectors->GetNumberOfTuples(), data->GetNumberOfPoints()));
  return vectors;
}

}  // namespace pellucid::fields
