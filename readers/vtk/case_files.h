// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pellucid::readers {

/// Returns the files that an EnSight case names, among other words that name no file: NAME, or
/// NAME*** for one of each time, whose digits stand there.
std::vector<std::filesystem::path> files_of_ensight(const std::filesystem::path& file);

/// Returns the files below those folders of an OpenFOAM case, and of its processors' parts, that
/// OpenFOAM keeps it in: constant, system, and one for each time, whose name is a number.
std::vector<std::filesystem::path> files_of_foam(const std::filesystem::path& file);

/// Returns the files that an NRRD header names for its data: of one name, or of LIST.
std::vector<std::filesystem::path> files_of_nrrd(const std::filesystem::path& file);

/// Returns the pattern, with its numbers, by which an NRRD header names its data's files; "" where
/// it has none.
std::string numbered_files_of_nrrd(const std::filesystem::path& file);

}  // namespace pellucid::readers
