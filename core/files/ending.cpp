// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/ending.h"

#include <algorithm>
#include <cctype>

namespace pellucid {

std::string small_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

}  // namespace pellucid
