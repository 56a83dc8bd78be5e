// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/screened_calls.h"

#include <fmt/format.h>

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

std::string text_of(const SmallPicture& picture) {
  return fmt::format("{} ({:.1f} ms, RMSE {:.4f})", picture.call, 1e3 * picture.seconds,
                     picture.rmse);
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

std::string screen_note(const std::string& scene, std::span<const ScreenedCall> screened) {
  std::string text = fmt::format(
      "Of {}, {} calls were not drawn in full: in smaller pictures another one erred less in less "
      "time, with no more memory. ",
      scene, screened.size());
  constexpr std::size_t shown = 3;
  for (std::size_t i = 0; i < std::min(shown, screened.size()); ++i)
    text +=
        fmt::format("{}{} by {}", i ? "; " : "", text_of(screened[i].own), text_of(screened[i].by));
  return text + (screened.size() > shown ? "; all of them are in screened.csv." : ".");
}

std::string csv_screen(const std::string& scene, std::span<const ScreenedCall> screened) {
  std::string text;
  for (const ScreenedCall& out : screened)
    text +=
        fmt::format("{},{},{},{}\n", csv_field(scene), out.size, csv_of(out.own), csv_of(out.by));
  return text;
}

}  // namespace pellucid::compare
