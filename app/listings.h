// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

namespace pellucid::app {

/// One of the program's tables, as `list` prints it.
struct Listing {
  std::string_view name;  // "methods"
  std::string_view kind;  // of a row, for messages: "method"
  /// An array of objects with the keys "name" and "title" first.
  nlohmann::ordered_json (*make)();
};

/// All tables, the most asked for first.
std::span<const Listing> listings();

}  // namespace pellucid::app
