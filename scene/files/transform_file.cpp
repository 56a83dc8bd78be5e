// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/transform_file.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/files/any_number.h"

namespace pellucid::scene {
namespace {

/// Farther from 1 a factor's square, which a normal's length takes, is 0 or infinite.
constexpr double smallest_factor = 1e-100, largest_factor = 1e100;

Vec3 read_scale(const JsonNode& node) {
  const Vec3 scale = node.is_array() ? node.vec3() : Vec3(node.number(-any, any));
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::abs(scale[axis]);
    if (!(size >= smallest_factor && size <= largest_factor))
      node.fail(fmt::format("{}; accepted: factors of size 1e-100 … 1e100", scale[axis]));
  }
  return scale;
}

}  // namespace

Transform read_transform(const JsonNode& node) {
  node.accept_keys({"translate", "rotate", "scale"});
  Transform transform;
  if (node.has("translate")) transform.translation = node["translate"].vec3();
  if (node.has("scale")) transform.scale = read_scale(node["scale"]);
  if (!node.has("rotate")) return transform;
  const JsonNode rotate = node["rotate"];
  rotate.accept_keys({"axis", "degrees"});
  transform.axis = rotate["axis"].vec3();
  if (transform.axis == Vec3(0)) rotate["axis"].fail("accepted: a direction other than 0");
  transform.degrees = rotate["degrees"].number(-any, any);
  return transform;
}

}  // namespace pellucid::scene
