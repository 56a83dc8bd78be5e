// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "compare/study/read_calls.h"

namespace pellucid::compare {

/// Returns whether an entry of a study's methods is a picture from elsewhere.
bool is_given(const JsonNode& node);

/// Reads {"external": NAME, "command": [WORD, …], "timeout": seconds, "output": "exr" or "png"} or
/// {"picture": FILE, "name": NAME, "ms": X, "bytes": N}; relative files start at `base`. Throws
/// InputError that names the entry's place, also for a name that a row of the catalogue has.
MethodCall read_given(const JsonNode& node, const std::filesystem::path& base,
                      const Catalogue& catalogue);

}  // namespace pellucid::compare
