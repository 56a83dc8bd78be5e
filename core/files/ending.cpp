// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/ending.h"

#include "core/options/lower_case.h"

namespace pellucid {

std::string small_ending(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

}  // namespace pellucid
