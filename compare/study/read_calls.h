// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "compare/methods/method_call.h"
#include "core/files/json_node.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// A Catalogue is the table whose rows the entries of a list of calls can name.
struct Catalogue {
  std::string_view kind;  // of a row, and the key of its name in an object: "method"
  std::span<const scene::MethodRow> rows;
  std::filesystem::path folder = {};  // that the paths of files start at
};

/// Reads an entry of a list of calls and expands its sweeps: "NAME[:key=value,…]",
/// {"method": NAME, key: value or [values], …}, or "*": every row in all its settings. Throws
/// InputError that names the entry's place and what is accepted.
std::vector<MethodCall> read_calls(const JsonNode& node, const Catalogue& catalogue);

/// Reads an entry that stands for one call. Throws InputError for a sweep.
MethodCall read_call(const JsonNode& node, const Catalogue& catalogue);

}  // namespace pellucid::compare
