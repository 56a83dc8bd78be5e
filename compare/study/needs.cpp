// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/files/files_read.h"
#include "core/files/json_node.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const JsonNode& node) {
  if (node.is_string()) return {node.string()};
  std::vector<std::string> files;
  for (const JsonNode& element : node.elements()) files.push_back(element.string());
  return files;
}

std::optional<fs::path> first_missing(const JsonNode& node, const fs::path& folder) {
  for (const std::string& file : files_of(node)) {
    fs::path path = without_dots(folder / file);
    std::error_code code;
    if (!fs::exists(path, code)) return path;
  }
  return std::nullopt;
}

void check_scene(const JsonNode& node, const std::string& name,
                 std::span<const std::string> scenes) {
  if (std::ranges::find(scenes, name) == scenes.end())
    node.fail(
        unknown_name("scene", name, std::vector<std::string_view>(scenes.begin(), scenes.end())));
}

}  // namespace

std::string LeftOutScene::text() const {
  return fmt::format("the scene '{}' is left out: {} is missing", scene, missing.string());
}

std::vector<LeftOutScene> read_needs(const JsonNode& node, const fs::path& folder,
                                     std::span<const std::string> scenes) {
  std::vector<LeftOutScene> left_out;
  for (const std::string& scene : node.keys()) {
    check_scene(node, scene, scenes);
    if (const auto missing = first_missing(node[scene], folder))
      left_out.push_back({scene, *missing});
  }
  if (!scenes.empty() && left_out.size() == scenes.size())
    node.fail(left_out.front().text() + ", and so are all others; accepted: one scene at least");
  return left_out;
}

}  // namespace pellucid::compare
