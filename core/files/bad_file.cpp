// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/bad_file.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid {

void bad_file(const std::filesystem::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

}  // namespace pellucid
