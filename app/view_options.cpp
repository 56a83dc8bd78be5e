// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "core/error.h"
#include "core/files/json_node.h"
#include "core/options/parameters.h"
#include "scene/cameras/foreign_cameras.h"
#include "scene/files/appearance_file.h"
#include "scene/view/camera_fit.h"

namespace pellucid::app {
namespace {

int side_of(std::string_view text, int most) {
  double side = 0;
  const bool fits = parse_number(text, side) && side >= 1 && side <= most;
  return fits && side == int(side) ? int(side) : 0;
}

std::array<int, 2> resolution_of(const std::string& text, int most) {
  const std::size_t cross = std::min(text.find_first_of("xX"), text.size());
  const int width = side_of(std::string_view(text).substr(0, cross), most);
  const int height =
      cross < text.size() ? side_of(std::string_view(text).substr(cross + 1), most) : 0;
  if (width == 0 || height == 0)
    throw InputError(
        fmt::format("--resolution: '{}'; accepted: WxH, each 1 … {} pixels", text, most));
  return {width, height};
}

std::string names_of_views() {
  std::string names;
  for (const scene::ViewDirection& view : scene::view_directions())
    names += (names.empty() ? "" : ", ") + std::string(view.name);
  return names;
}

/// Without a background colours are what they are over black: premultiplied.
void take_background(const std::string& text, scene::ViewRequest& view) {
  view.without_background = text == "none";
  const nlohmann::json color = text;
  view.background = view.without_background
                        ? Vec3(0)
                        : scene::read_rgb(JsonNode("--background (or none)", color));
}

}  // namespace

void add_view_options(CLI::App& command, scene::ViewRequest& view, int most) {
  command.add_option("--camera", view.camera,
                     "In the place of the scene's: any of eye=X,Y,Z,target=X,Y,Z,up=X,Y,Z and "
                     "fov=DEGREES or, orthographic, height=LENGTH; or FILE[:NUMBER], a camera of "
                     "another program's file: " +
                         scene::foreign_camera_endings());
  command.add_option("--view", view.view,
                     "See all of the scene, as large as it can be, from: " + names_of_views());
  command.add_option_function<std::string>(
      "--resolution",
      [&view, most](const std::string& text) { view.resolution = resolution_of(text, most); },
      "Size of the picture, WxH pixels");
  command.add_option_function<std::string>(
      "--background", [&view](const std::string& text) { take_background(text, view); },
      "Colour behind all, #rrggbb or a name; or none: colours premultiplied by alpha in .exr, "
      "straight ones and alpha in .png");
  command
      .add_option_function<int>(
          "--samples", [&view](int samples) { view.samples = samples; },
          "Samples per pixel and axis")
      ->check(CLI::Range(1, 16));
}

}  // namespace pellucid::app
