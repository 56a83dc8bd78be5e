// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace pellucid {

/// Returns the ending of a file's name in small letters, ".exr" of "X.EXR": files are told apart
/// by it whichever letters they are written in.
std::string small_ending(const std::filesystem::path& path);

}  // namespace pellucid
