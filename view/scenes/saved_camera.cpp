// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/scenes/saved_camera.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "scene/files/camera_file.h"

namespace pellucid::view {
namespace {

struct Span {
  std::size_t begin, end;
};

/// The keys of the outermost object and where their values stand, in a text that is known to be
/// JSON. Only quotation marks and brackets need to be understood.
class OuterKeys {
 public:
  explicit OuterKeys(std::string_view text) : text_(text) {
    for (at_ = 0; at_ < text_.size(); ++at_) take(text_[at_]);
  }
  std::optional<Span> value_of(std::string_view key) const {
    for (const auto& [name, value] : values_)
      if (name == key) return value;
    return std::nullopt;
  }
  std::size_t first_key() const { return first_key_; }

 private:
  void take(char c) {
    if (c == '"') return take_string();
    if (c == ':' && depth_ == 1) begin_ = text_.find_first_not_of(" \t\r\n", at_ + 1);
    if ((c == ',' || c == '}') && depth_ == 1) finish();
    if (c == '{' || c == '[') ++depth_;
    if (c == '}' || c == ']') --depth_;
  }
  void take_string() {
    const std::size_t start = at_;
    for (++at_; text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    if (depth_ != 1 || begin_ != 0) return;
    key_ = nlohmann::json::parse(text_.substr(start, at_ + 1 - start)).get<std::string>();
    if (values_.empty() && first_key_ == 0) first_key_ = start;
  }
  void finish() {
    if (begin_ == 0) return;
    const std::size_t last = text_.find_last_not_of(" \t\r\n", at_ - 1);
    values_.push_back({key_, {begin_, last + 1}});
    begin_ = 0;
  }

  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0, first_key_ = 0;  // begin_: of a value; 0: none has begun
  int depth_ = 0;
  std::string key_;
  std::vector<std::pair<std::string, Span>> values_;
};

/// On one line, as people write it.
std::string text_of(const scene::Camera& camera) {
  std::string spaced = "{ ";
  for (const char c : scene::camera_json(camera).dump().substr(1)) {
    if (c == '}') spaced += ' ';
    spaced += c;
    if (c == ':' || c == ',') spaced += ' ';
  }
  return spaced;
}

/// The text with another camera behind those of the array `views`.
std::string appended(const std::string& text, const Span& views, bool is_empty,
                     const scene::Camera& camera) {
  const std::size_t bracket = views.end - 1;
  const std::size_t last = text.find_last_not_of(" \t\r\n", bracket - 1);
  std::string changed = text;
  changed.insert(last + 1, (is_empty ? "" : ",\n  ") + text_of(camera));
  return changed;
}

}  // namespace

std::string with_camera(const std::string& file, const std::string& text,
                        const scene::Camera& camera) {
  nlohmann::json wanted = parse_json(file, text);
  if (!wanted.is_object()) throw InputError(file + ": accepted: a scene, an object of JSON");
  const OuterKeys keys(text);
  std::string changed = text;
  if (const auto value = keys.value_of("camera"))
    changed.replace(value->begin, value->end - value->begin, text_of(camera));
  else
    changed.insert(keys.first_key(), "\"camera\": " + text_of(camera) + ",\n  ");
  wanted["camera"] = scene::camera_json(camera);
  if (parse_json(file, changed) != wanted)
    throw WorkError(file + ": its camera cannot be replaced");
  return changed;
}

std::string with_view(const std::string& file, const std::string& text,
                      const scene::Camera& camera) {
  nlohmann::json wanted = parse_json(file, text);
  if (!wanted.is_object()) throw InputError(file + ": accepted: a study, an object of JSON");
  const OuterKeys keys(text);
  nlohmann::json& views = wanted["views"];
  std::string changed = text;
  if (views.is_null()) {
    changed.insert(keys.first_key(), "\"views\": [" + text_of(camera) + "],\n  ");
  } else if (views.is_array()) {
    changed = appended(text, *keys.value_of("views"), views.empty(), camera);
  } else {
    throw InputError(fmt::format("{}: views: {}; accepted here: a list of cameras, or none", file,
                                 views.dump()));
  }
  views.push_back(nlohmann::json(scene::camera_json(camera)));
  if (parse_json(file, changed) != wanted) throw WorkError(file + ": its views cannot be added to");
  return changed;
}

std::size_t add_view(const std::filesystem::path& file, const scene::Camera& camera) {
  const std::string changed = with_view(file.string(), read_text(file), camera);
  write_text(file, changed);
  return parse_json(file.string(), changed)["views"].size();
}

void save_camera(const std::filesystem::path& file, const scene::Camera& camera) {
  write_text(file, with_camera(file.string(), read_text(file), camera));
}

}  // namespace pellucid::view
