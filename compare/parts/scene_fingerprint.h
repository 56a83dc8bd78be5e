// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns 16 hexadecimal digits that are the same for scenes that were read from files of the same
/// names and contents, in whatever folders, and changed by the same further `option`. Files of one
/// name in several folders are told apart by the order of their paths.
std::string scene_fingerprint(const std::set<std::filesystem::path>& files_read,
                              std::string_view option);

}  // namespace pellucid::compare
