// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/contents.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <iostream>

#include "core/range_text.h"

namespace pellucid::app {
namespace {

nlohmann::ordered_json number_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json to_json(const ArrayContents& array) {
  nlohmann::ordered_json ranges = nlohmann::ordered_json::array();
  for (const Vec2& range : array.ranges)
    ranges.push_back({number_json(range.x), number_json(range.y)});
  return {{"name", array.name},
          {"at", array.at},
          {"components", array.ranges.size()},
          {"type", array.type},
          {"count", array.count},
          {"ranges", ranges},
          {"not_finite", array.not_finite}};
}

/// "(x, y, z) … (x, y, z)".
std::string text_of(const Box3& box) {
  std::array<std::array<std::string, 3>, 2> corners;
  for (int a = 0; a < 3; ++a) {
    const auto ends = range_ends(box.min[a], box.max[a]);
    for (const std::size_t end : {0, 1}) corners[end][std::size_t(a)] = ends[end];
  }
  return fmt::format("({}) … ({})", fmt::join(corners[0], ", "), fmt::join(corners[1], ", "));
}

std::string text_of(const ArrayContents& array) {
  std::string text = fmt::format("  {} array '{}': {} × {}", array.at, array.name,
                                 array.ranges.size(), array.type);
  for (std::size_t c = 0; c < array.ranges.size(); ++c) {
    const Vec2& range = array.ranges[c];
    text += c == 0 ? ", " : "; ";
    text += range.x <= range.y ? range_text(range.x, range.y) : "no finite value";
  }
  if (array.not_finite > 0) text += fmt::format(", {} not finite", array.not_finite);
  return text;
}

std::string counts_of(const FileContents& contents) {
  std::vector<std::string> counts;
  for (const auto& [name, count] : contents.counts)
    counts.push_back(fmt::format("{} {}", count, name));
  return fmt::format("{}", fmt::join(counts, ", "));
}

std::string text_of(const nlohmann::ordered_json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

nlohmann::ordered_json json_of(const Vec3& v) {
  return {number_json(v.x), number_json(v.y), number_json(v.z)};
}

nlohmann::ordered_json to_json(const FileContents& contents) {
  nlohmann::ordered_json json{{"kind", contents.kind}, {"format", contents.title}};
  if (contents.bounds && !contents.bounds->empty())
    json["bounds"] = {{"min", json_of(contents.bounds->min)},
                      {"max", json_of(contents.bounds->max)}};
  json["counts"] = nlohmann::ordered_json::object();
  for (const auto& [name, count] : contents.counts) json["counts"][name] = count;
  json["arrays"] = nlohmann::ordered_json::array();
  for (const ArrayContents& array : contents.arrays) json["arrays"].push_back(to_json(array));
  json["times"] = contents.times;
  json.update(contents.more);
  return json;
}

void print(const FileContents& contents) {
  std::cout << fmt::format("{} ({})\n", contents.kind, contents.title);
  if (contents.bounds && !contents.bounds->empty())
    std::cout << fmt::format("  bounds: {}\n", text_of(*contents.bounds));
  if (!contents.counts.empty()) std::cout << fmt::format("  counts: {}\n", counts_of(contents));
  for (const auto& [key, value] : contents.more.items()) {
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      std::cout << fmt::format("  {}: {}\n", key, text_of(value));
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      std::cout << fmt::format("  {}[{}]: {}\n", key, i, text_of(value[i]));
  }
  for (const ArrayContents& array : contents.arrays) std::cout << text_of(array) << '\n';
  if (!contents.times.empty()) {
    const auto ends = range_ends(contents.times.front(), contents.times.back());
    std::cout << fmt::format("  times: {} from {} to {}\n", contents.times.size(), ends[0],
                             ends[1]);
  }
}

}  // namespace pellucid::app
