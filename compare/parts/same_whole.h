// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "compare/deep/deep_info.h"

namespace pellucid::compare {

/// A NamedInfo is what a file says of itself.
struct NamedInfo {
  std::filesystem::path file;
  DeepInfo info;
};

/// Throws InputError that names both files unless they are parts of one picture, cut into as many.
void check_same_picture(const NamedInfo& first, const NamedInfo& other);

/// Throws InputError that names the file unless these are all parts of one whole, each once.
void check_same_whole(const std::vector<NamedInfo>& parts);

}  // namespace pellucid::compare
