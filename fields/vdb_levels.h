#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "fields/level.h"

namespace pellucid {

/// Every grid of an OpenVDB file that has the scalar, as a level: scalar grids of that name (float
/// or double), or, for a derived scalar, all velocity grids (whatever their names). Throws
/// InputError for a file that is missing or damaged, and for a grid whose active voxels do not fill
/// a box, whose voxels are not cubes along the world's axes, or that check_level() refuses.
std::vector<ScalarLevel> read_vdb_levels(const std::filesystem::path& path,
                                         std::string_view scalar);

}  // namespace pellucid
