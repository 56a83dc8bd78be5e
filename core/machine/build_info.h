// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid {

/// These texts say what the program was built from: the project's version, the short hash of its
/// commit ("-dirty" when the tree was changed), and the compiler's name, version and build type.
///@{
extern const char* const build_version;
extern const char* const build_commit;
extern const char* const build_compiler;
///@}

}  // namespace pellucid
