// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "fields/readers/file_field.h"

class vtkDataSet;

namespace pellucid::fields {

/// Makes a field of a data set whose indices have been checked (readers/vtk/cell_rules.h); `path`
/// names it in messages, and `note` is added to the description. Throws InputError for data that
/// hold no such field.
std::unique_ptr<VectorField> field_of(const vtkSmartPointer<vtkDataSet>& data,
                                      const FileOptions& options, const std::filesystem::path& path,
                                      const std::string& note = {});

}  // namespace pellucid::fields
