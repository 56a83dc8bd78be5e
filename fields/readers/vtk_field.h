// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"

namespace pellucid::fields {

struct FileOptions;

/// Image and rectilinear data become a dense array of our own; curvilinear and unstructured grids
/// are searched with VTK's cell locator.
std::unique_ptr<VectorField> read_vtk_field(const std::filesystem::path& path,
                                            const FileOptions& options);

}  // namespace pellucid::fields
