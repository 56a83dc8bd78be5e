// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/pictures/picture_text.h"
#include "core/files/json_node.h"
#include "scene/parts/scene_part.h"

namespace pellucid::compare {

/// A DeepInfo says what a deep picture is of: all that has to be the same of two parts of one
/// picture, and which part it is.
struct DeepInfo {
  std::string scene;               // its name
  std::string fingerprint;         // of the scene's file and all that it names
  std::string camera;              // see scene::camera_text()
  std::string opacities;           // the call that chose them; empty: none did
  int width = 0, height = 0;       // pixels
  std::optional<Vec3> background;  // red, green, blue; nothing: colours are premultiplied by A
  std::vector<int> opaque;         // the objects that end a ray, by their index in Scene::objects
  std::string program;             // that has written it: version and commit
  std::string build;               // see build_id()
  scene::PartNumber part;

  bool operator==(const DeepInfo&) const = default;
};

/// A DeepSource is what a loaded scene does not say of itself.
struct DeepSource {
  std::string fingerprint;  // see DeepInfo
  std::string opacities;    // see DeepInfo
  bool without_background;  // colours are to be premultiplied by A
};

/// Returns what is to be said of a part's picture, or of a whole scene's, which is part 1 of 1.
DeepInfo deep_info(const scene::Scene& scene, const scene::PartNumber& part,
                   const DeepSource& source);

/// Returns what a picture that is composited of it says of itself: drawn by `method`.
PictureOrigin origin_of(const DeepInfo& info, const std::string& method);

/// Returns the background to composite over: black where there is none.
Vec3 backdrop(const DeepInfo& info);

/// Returns it as one line of JSON.
std::string text_of(const DeepInfo& info);

/// Returns what such a text says. Throws InputError that begins with `file` for any other.
DeepInfo deep_info_of(const std::string& file, const std::string& text);
/// Returns what such a text says within a larger one. Throws InputError likewise.
DeepInfo deep_info_of(const JsonNode& node);

}  // namespace pellucid::compare
