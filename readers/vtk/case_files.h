// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

namespace pellucid::readers {

/// Returns the files that an EnSight case names, among other words that name no file: NAME, or
/// NAME*** for one of each time, whose digits stand there.
std::vector<std::filesystem::path> files_of_ensight(const std::filesystem::path& file);

/// Returns the files below those folders of an OpenFOAM case, and of its processors' parts, that
/// OpenFOAM keeps it in: constant, system, and one for each time, whose name is a number.
std::vector<std::filesystem::path> files_of_foam(const std::filesystem::path& file);

}  // namespace pellucid::readers
