// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/camera_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/options/keyed_words.h"
#include "core/options/option_table.h"
#include "scene/cameras/foreign_cameras.h"
#include "scene/files/any_number.h"
#include "scene/view/camera_path.h"

namespace pellucid::scene {
namespace {

constexpr std::array<std::string_view, 5> keys{"eye", "target", "up", "fov", "height"};

std::string text_of(const Vec3& v) {
  return fmt::format("{},{},{}", number_text(v.x), number_text(v.y), number_text(v.z));
}

double number_of(std::string_view key, std::string_view word) {
  double value = 0;
  if (!parse_number(word, value) || !(std::abs(value) <= any))
    throw InputError(fmt::format("--camera: {}: '{}'; accepted: a finite number", key, word));
  return value;
}

void set(Camera& camera, std::string_view key, const std::vector<std::string_view>& words) {
  const bool is_number = key == "fov" || key == "height";
  if (words.size() != (is_number ? 1 : 3))
    throw InputError(fmt::format("--camera: {}={}; accepted: {}", key, fmt::join(words, ","),
                                 is_number ? "a number" : "three numbers, X,Y,Z"));
  if (is_number) {
    (key == "fov" ? camera.fov : camera.height) = number_of(key, words[0]);
    camera.projection = key == "fov" ? Projection::perspective : Projection::orthographic;
    return;
  }
  Vec3& v = key == "eye" ? camera.eye : key == "target" ? camera.target : camera.up;
  v = {number_of(key, words[0]), number_of(key, words[1]), number_of(key, words[2])};
}

}  // namespace

Camera read_camera(const JsonNode& node) {
  node.accept_keys({"type", "eye", "target", "up", "fov", "height"});
  Camera camera;
  const std::string type =
      node.has("type") ? node["type"].one_of({"perspective", "orthographic"}) : "perspective";
  if (type == "orthographic") camera.projection = Projection::orthographic;
  const std::string_view foreign = type == "orthographic" ? "fov" : "height";
  if (node.has(foreign))
    node[foreign].fail(fmt::format("a camera of type {} has none; it takes {}", type,
                                   type == "orthographic" ? "height" : "fov"));
  if (node.has("eye")) camera.eye = node["eye"].vec3();
  if (node.has("target")) camera.target = node["target"].vec3();
  if (node.has("up")) camera.up = node["up"].vec3();
  if (node.has("fov")) camera.fov = node["fov"].number(-any, any);
  if (node.has("height")) camera.height = node["height"].number(-any, any);
  return camera;
}

Camera read_camera(const JsonNode& node, const std::filesystem::path& folder) {
  if (!node.is_string()) return read_camera(node);
  const auto foreign = at_place(node, [&] { return foreign_camera(node.string()); });
  if (!foreign)
    node.fail(fmt::format("'{}'; accepted: a camera's keys, or a file ending in {}", node.string(),
                          foreign_camera_endings()));
  return at_place(node, [&] { return read_foreign_camera(*foreign, folder); });
}

std::vector<Camera> read_camera_path(const JsonNode& node, const std::filesystem::path& folder,
                                     const Camera& camera, std::string_view change) {
  node.accept_keys({"frames", "orbit", "keys"});
  const int frames = node["frames"].integer(2, 100000);
  if (node.has("orbit") == node.has("keys")) node.fail("accepted: one of the keys orbit, keys");
  if (node.has("orbit")) return orbit(camera, node["orbit"].number(-any, any), frames);
  std::vector<Camera> keys;
  for (const JsonNode& key : node["keys"].elements())
    keys.push_back(camera_of_text(change, read_camera(key, folder)));
  std::vector<Camera> path = at_place(node, [&] { return between_keys(keys, frames); });
  at_place(node, [&] { std::ranges::for_each(path, camera_frame); });
  return path;
}

nlohmann::ordered_json camera_json(const Camera& camera) {
  const auto array = [](const Vec3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
  const bool perspective = camera.projection == Projection::perspective;
  nlohmann::ordered_json json{{"type", perspective ? "perspective" : "orthographic"},
                              {"eye", array(camera.eye)},
                              {"target", array(camera.target)},
                              {"up", array(camera.up)}};
  json[perspective ? "fov" : "height"] = perspective ? camera.fov : camera.height;
  return json;
}

nlohmann::ordered_json samples_json(const PixelSampling& sampling) {
  if (sampling.frames > 0) return {{"frames", sampling.frames}};
  return sampling.per_axis;
}

std::string camera_text(const Camera& camera) {
  const bool perspective = camera.projection == Projection::perspective;
  return fmt::format("eye={},target={},up={},{}={}", text_of(camera.eye), text_of(camera.target),
                     text_of(camera.up), perspective ? "fov" : "height",
                     number_text(perspective ? camera.fov : camera.height));
}

Camera camera_of_text(std::string_view text, Camera camera) {
  if (text.empty()) return camera;
  if (const auto foreign = foreign_camera(text)) return read_foreign_camera(*foreign, {});
  const auto words = keyed_words("--camera", text, keys);
  if (words.contains("fov") && words.contains("height"))
    throw InputError(
        "--camera: accepted: one of fov (a perspective camera) and height (an orthographic one)");
  for (const auto& [key, numbers] : words) set(camera, key, numbers);
  return camera;
}

bool sets_eye(std::string_view text) {
  if (foreign_camera(text)) return true;
  return !text.empty() && keyed_words("--camera", text, keys).contains("eye");
}

}  // namespace pellucid::scene
