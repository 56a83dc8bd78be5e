// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "fields/readers/file_field.h"
#include "readers/vdb/grid_blocks.h"

namespace pellucid::fields {

/// Makes a field of the vector grid that the options mean; `path` names the grids' file in
/// messages. Throws InputError for grids that hold no such field.
std::unique_ptr<VectorField> field_of(std::span<const readers::VdbGrid> grids,
                                      const FileOptions& options,
                                      const std::filesystem::path& path);

}  // namespace pellucid::fields
