// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/camera_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/view/camera_path.h"

namespace pellucid::scene {
namespace {

constexpr double any = std::numeric_limits<double>::max();

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

std::vector<Camera> read_camera_path(const JsonNode& node, const Camera& camera) {
  node.accept_keys({"frames", "orbit", "keys"});
  const int frames = node["frames"].integer(2, 100000);
  if (node.has("orbit") == node.has("keys")) node.fail("accepted: one of the keys orbit, keys");
  if (node.has("orbit")) return orbit(camera, node["orbit"].number(-any, any), frames);
  std::vector<Camera> keys;
  for (const JsonNode& key : node["keys"].elements()) keys.push_back(read_camera(key));
  std::vector<Camera> path = at_place(node, [&] { return between_keys(keys, frames); });
  at_place(node, [&] { std::ranges::for_each(path, camera_frame); });
  return path;
}

}  // namespace pellucid::scene
