// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid {

extern const char* const build_version;   // of the project
extern const char* const build_commit;    // short hash, "-dirty" when the tree was changed
extern const char* const build_compiler;  // name, version and build type

}  // namespace pellucid
