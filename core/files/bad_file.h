// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace pellucid {

/// Throws the InputError "path: why" of a file that cannot be taken.
[[noreturn]] void bad_file(const std::filesystem::path& path, std::string_view why);

}  // namespace pellucid
