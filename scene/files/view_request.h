// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/vec.h"

namespace pellucid::scene {

/// A ViewRequest says from where a scene is looked at, and how finely, in the place of what its
/// file says.
struct ViewRequest {
  std::string camera;  // as camera_of_text() takes it; empty: the scene's own
  std::string view;    // the name of a ViewDirection, from which all is seen; not with `camera`
  std::optional<std::array<int, 2>> resolution = std::nullopt;  // width and height, pixels
  std::optional<int> samples = std::nullopt;                    // per pixel and axis
  std::optional<Vec3> background = std::nullopt;  // red, green, blue in [0, 1]; of none: black
  bool without_background = false;                // colours are to be premultiplied by their alpha
  bool along_path = false;                        // from the cameras of the file's camera_path
};

}  // namespace pellucid::scene
