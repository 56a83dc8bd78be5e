// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace pellucid {

/// These texts say what the program was built from: the project's version, the short hash of its
/// commit ("-dirty" when the tree was changed), and the compiler's name, version and build type.
///@{
extern const char* const build_version;
extern const char* const build_commit;
extern const char* const build_compiler;
///@}

/// Returns the hash of the code and data of this program, or of the library that holds this code,
/// that the linker made (GNU build ID), in hexadecimal digits: two programs share it when they were
/// built from the same sources by the same tools. Returns "unknown" where the linker made none.
std::string build_id();

}  // namespace pellucid
