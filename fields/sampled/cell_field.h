// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"
#include "fields/files/vector_array.h"

class vtkDataSet;

namespace pellucid::fields {

/// Makes a field over the volume cells of a grid, or over its surface cells where it has no others
/// and they lie on a plane; `vectors` are its velocities by point or by cell, in world units per
/// unit of time. Throws InputError, naming `path`, as checked_cells() does.
std::unique_ptr<VectorField> make_cell_field(vtkDataSet* data, const Vectors& vectors,
                                             const std::filesystem::path& path);

}  // namespace pellucid::fields
