// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace pellucid {

/// Parses JSON. Throws InputError that begins with `file`: with line and column for what is no
/// JSON, for a number that a double cannot hold, for a key that an object has twice, and for more
/// than 100 levels of nesting, which no file of ours has and a recursion would not survive.
nlohmann::json parse_json(const std::string& file, std::string_view text);

/// Reads a file and parses it as JSON. Throws as read_text() and parse_json().
nlohmann::json read_json(const std::filesystem::path& path);

/// Writes JSON on one line, or indented. Bytes that are no UTF-8, which a file's name may have,
/// become the replacement character.
std::string json_text(const nlohmann::json& json, int indent = -1);

}  // namespace pellucid
