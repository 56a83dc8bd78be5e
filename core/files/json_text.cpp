// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/json_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid {
namespace {

using nlohmann::json;

constexpr int deepest = 100;  // levels

constexpr char nul = '\0';

bool holds_nul(std::string_view text) { return text.find(nul) != text.npos; }

/// The parser takes a NUL for the end of its input and would not look at what follows. Zeros alone
/// fill some files up, as chunks of .glb.
void refuse_text_behind_nul(const std::string& file, std::string_view text) {
  const std::size_t end = text.find(nul);
  if (end != text.npos && text.find_first_not_of(nul, end) != text.npos)
    throw InputError(fmt::format("{}: byte {} is 0, and more follows; accepted: JSON", file, end));
}

/// Watches what the parser meets, for what its result can't tell.
class Watch {
 public:
  explicit Watch(const std::string& file) : file_(file) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (depth > deepest)
      throw InputError(fmt::format("{}: nested more than {} levels deep", file_, deepest));
    if ((event == json::parse_event_t::value || event == json::parse_event_t::key) &&
        parsed.is_string() && holds_nul(parsed.get_ref<const std::string&>()))
      throw InputError(
          fmt::format("{}: a text has the character \\u0000, at which systems cut it", file_));
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw InputError(fmt::format("{}: the key '{}' is there twice in one object", file_,
                                   parsed.get<std::string>()));
    return true;
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

}  // namespace

json parse_json(const std::string& file, std::string_view text) {
  refuse_text_behind_nul(file, text);
  try {
    Watch watch(file);
    return json::parse(text, [&](int depth, json::parse_event_t event, json& parsed) {
      return watch(depth, event, parsed);
    });
  } catch (const json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: …": drop the prefix.
    const std::string what = error.what();
    throw InputError(fmt::format("{}: {}", file, what.substr(what.find("] ") + 2)));
  }
}

json read_json(const std::filesystem::path& path) {
  return parse_json(path.string(), read_text(path));
}

std::string json_text(const json& json, int indent) {
  return json.dump(indent, ' ', false, json::error_handler_t::replace);
}

}  // namespace pellucid
