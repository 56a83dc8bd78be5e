// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the files that come with the program lie. All are found relative to the file that holds
// this code, the program or Python's module, so that a copy or an installation may be moved.

#include <filesystem>
#include <string_view>

namespace pellucid {

/// Returns the loaded file, program or shared library, that holds this code.
const std::filesystem::path& own_file();

/// Returns the helper program of that name: in the folder of own_file(), in the build folder that
/// own_file() is in, or in libexec/pellucid of the installation. Where there is none it is the
/// first of these places.
std::filesystem::path helper_program(std::string_view name);

/// Returns the folder of that name, "studies" or "scenes": in share/pellucid of the installation,
/// or among the sources of the build folder that own_file() is in. Empty where there is none.
std::filesystem::path data_folder(std::string_view name);

}  // namespace pellucid
