// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/scenes/view_state.h"

#include <nlohmann/json.hpp>

#include "scene/files/camera_file.h"

namespace pellucid::view {
namespace {

constexpr int largest_side = 4096;  // a page shows no more
constexpr int most_samples = 16;    // as a scene file accepts them

RawOptions read_settings(const JsonNode& node) {
  if (!node.is_object()) node.fail("accepted: an object of texts");
  RawOptions settings;
  for (const auto& [name, text] : node.value().items()) settings[name] = node[name].string();
  return settings;
}

}  // namespace

bool ViewState::operator==(const ViewState& other) const {
  return objects == other.objects && width == other.width && height == other.height &&
         samples == other.samples &&
         scene::camera_text(camera) == scene::camera_text(other.camera) &&
         camera.projection == other.camera.projection;
}

ViewState read_view_state(const JsonNode& node) {
  ViewState state;
  state.camera = scene::read_camera(node["camera"]);
  at_place(node["camera"], [&] { return scene::camera_frame(state.camera); });
  const auto sides = node["size"].elements();
  if (sides.size() != 2) node["size"].fail("accepted: two integers, width and height");
  state.width = sides[0].integer(1, largest_side);
  state.height = sides[1].integer(1, largest_side);
  if (node.has("samples")) state.samples = node["samples"].integer(1, most_samples);
  if (node.has("objects"))
    for (const JsonNode& object : node["objects"].elements())
      state.objects.push_back(read_settings(object));
  return state;
}

}  // namespace pellucid::view
