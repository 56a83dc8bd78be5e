// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/blocks.h"
#include "readers/vdb/grid_blocks.h"

namespace pellucid::readers {

/// Reads all grids of a .vdb file by OpenVDB, in a process of its own, in the file's order; of
/// those with another name than `wanted`, if one or several with commas are given, only name and
/// type. Throws InputError that names the file for what OpenVDB complains of and what it dies over.
std::vector<VdbGrid> read_vdb_grids(const std::filesystem::path& path,
                                    const std::string& wanted = {});

/// Reads the points of a .vdb file in the same way; see parse_vdb_points().
Blocks read_vdb_point_blocks(const std::filesystem::path& path);

}  // namespace pellucid::readers
