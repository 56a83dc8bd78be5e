// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/screened_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/report/tables.h"
#include "core/files/json_node.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json to_json(const SmallPicture& picture) {
  return {{"call", picture.call},
          {"seconds", picture.seconds},
          {"rmse", picture.rmse},
          {"bytes", picture.bytes}};
}

SmallPicture picture_of(const json& value) {
  return {value.at("call"), value.at("seconds"), value.at("rmse"), value.at("bytes")};
}

std::string csv_of(const SmallPicture& picture) {
  return fmt::format("{},{},{},{}", csv_field(picture.call), picture.seconds, picture.rmse,
                     picture.bytes);
}

}  // namespace

void write_screen(const fs::path& file, const std::string& key,
                  std::span<const ScreenedCall> screened) {
  json calls = json::array();
  for (const ScreenedCall& out : screened)
    calls.push_back({{"size", out.size}, {"own", to_json(out.own)}, {"by", to_json(out.by)}});
  write_text(file, json_text({{"key", key}, {"calls", calls}}, 1) + "\n");
}

std::optional<std::vector<ScreenedCall>> read_screen(const fs::path& file, const std::string& key) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    const json screen = read_json(file);
    if (screen.at("key") != key) return std::nullopt;
    std::vector<ScreenedCall> screened;
    for (const json& out : screen.at("calls"))
      screened.push_back({out.at("size"), picture_of(out.at("own")), picture_of(out.at("by"))});
    return screened;
  } catch (const std::exception&) {  // what a kill or another version has left: screened again
    return std::nullopt;
  }
}

std::string screen_note(std::span<const std::pair<std::string, std::size_t>> scenes) {
  std::vector<std::string> counts;
  for (const auto& [scene, calls] : scenes)
    counts.push_back(fmt::format("{} call{} of {}", calls, calls == 1 ? "" : "s", scene));
  return fmt::format(
      "Not drawn in full, since in smaller pictures another call erred less in less time, with no "
      "more memory: {}. screened.csv names them, and what they were beaten by.",
      fmt::join(counts, ", "));
}

std::string csv_screen(const std::string& scene, std::span<const ScreenedCall> screened) {
  std::string text;
  for (const ScreenedCall& out : screened)
    text +=
        fmt::format("{},{},{},{}\n", csv_field(scene), out.size, csv_of(out.own), csv_of(out.by));
  return text;
}

}  // namespace pellucid::compare
