// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/deep/deep_info.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/machine/build_info.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {
namespace {

constexpr int largest = std::numeric_limits<int>::max();

scene::PartNumber part_of(const JsonNode& node) {
  const auto numbers = node.elements();
  if (numbers.size() != 2) node.fail("accepted: two integers");
  scene::PartNumber part;
  part.count = numbers[1].integer(1, scene::most_parts);
  part.part = numbers[0].integer(1, part.count);
  return part;
}

constexpr const char* no_background = "none";  // as --background takes it

nlohmann::json background_json(const std::optional<Vec3>& background) {
  if (!background) return no_background;
  return {background->r, background->g, background->b};
}

std::optional<Vec3> background_of(const JsonNode& node) {
  if (!node.is_string()) return node.vec3();
  node.one_of({no_background});
  return std::nullopt;
}

}  // namespace

DeepInfo deep_info(const scene::Scene& scene, const scene::PartNumber& part,
                   const DeepSource& source) {
  DeepInfo info;
  info.scene = scene.name;
  info.fingerprint = source.fingerprint;
  info.opacities = source.opacities;
  info.camera = scene::camera_text(scene.camera);
  info.width = scene.width;
  info.height = scene.height;
  if (!source.without_background) info.background = scene.background;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].opaque) info.opaque.push_back(int(i));
  info.program = fmt::format("{} ({})", build_version, build_commit);
  info.build = build_id();
  info.part = part;
  return info;
}

PictureOrigin origin_of(const DeepInfo& info, const std::string& method) {
  return {info.scene, info.camera, info.background, method, info.opacities};
}

Vec3 backdrop(const DeepInfo& info) { return info.background.value_or(Vec3(0)); }

std::string text_of(const DeepInfo& info) {
  return json_text({{"format", "pellucid-deep"},
                    {"version", 1},
                    {"scene", info.scene},
                    {"fingerprint", info.fingerprint},
                    {"camera", info.camera},
                    {"opacities", info.opacities},
                    {"resolution", {info.width, info.height}},
                    {"background", background_json(info.background)},
                    {"opaque", info.opaque},
                    {"program", info.program},
                    {"build", info.build},
                    {"part", {info.part.part, info.part.count}}});
}

DeepInfo deep_info_of(const std::string& file, const std::string& text) {
  const nlohmann::json json = parse_json(file, text);
  return deep_info_of(JsonNode(file, json));
}

DeepInfo deep_info_of(const JsonNode& root) {
  root.accept_keys({"format", "version", "scene", "fingerprint", "camera", "opacities",
                    "resolution", "background", "opaque", "program", "build", "part"});
  root["format"].one_of({"pellucid-deep"});
  root["version"].integer(1, 1);
  DeepInfo info;
  info.scene = root["scene"].string();
  info.fingerprint = root["fingerprint"].string();
  info.camera = root["camera"].string();
  if (root.has("opacities")) info.opacities = root["opacities"].string();
  const auto sides = root["resolution"].elements();
  if (sides.size() != 2) root["resolution"].fail("accepted: two integers, width and height");
  info.width = sides[0].integer(1, largest);
  info.height = sides[1].integer(1, largest);
  info.background = background_of(root["background"]);
  for (const JsonNode& object : root["opaque"].elements())
    info.opaque.push_back(object.integer(0, largest));
  info.program = root["program"].string();
  info.build = root["build"].string();
  info.part = part_of(root["part"]);
  return info;
}

}  // namespace pellucid::compare
