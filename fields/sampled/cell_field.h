// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"

class vtkDataArray;
class vtkDataSet;

namespace pellucid::fields {

/// Makes a field over the volume cells of a curvilinear or unstructured grid; `vectors` are its
/// velocities by point, in world units per unit of time. Cells of lower dimension are left out.
/// Throws InputError, naming `path`, for connectivity that points nowhere, for cells that cannot be
/// searched and for points that are not finite.
std::unique_ptr<VectorField> make_cell_field(vtkDataSet* data, vtkDataArray* vectors,
                                             const std::filesystem::path& path);

}  // namespace pellucid::fields
