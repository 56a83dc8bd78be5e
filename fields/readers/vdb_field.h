// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "fields/field.h"

namespace pellucid::fields {

struct FileOptions;

/// The vector grid of an OpenVDB file. Where its active voxels fill a box it becomes a dense array,
/// whose look-ups are several times faster; otherwise each sampler keeps one accessor. Samples
/// exist where all voxels of the stencil are active: the background never leaks in.
std::unique_ptr<VectorField> read_vdb_field(const std::filesystem::path& path,
                                            const FileOptions& options);

}  // namespace pellucid::fields
