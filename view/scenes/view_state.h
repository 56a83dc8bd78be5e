// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/files/json_node.h"
#include "core/options/parameters.h"
#include "scene/view/camera.h"

namespace pellucid::view {

/// A ViewState says how a page looks at a scene. Pages send it whole with each request, so that the
/// program keeps nothing of them.
struct ViewState {
  std::vector<RawOptions>
      objects;  // settings of control_rows(); as many as the scene file's, or none
  scene::Camera camera;
  int width = 0, height = 0;  // of the picture, pixels
  int samples = 1;            // per pixel and axis

  bool operator==(const ViewState& other) const;
};

/// The keys of a request that read_view_state() reads.
inline constexpr std::string_view state_keys[] = {"objects", "camera", "size", "samples"};

/// Reads {"camera" as a scene file has it, "size": [width, height], "samples", "objects": [{NAME:
/// TEXT}]}; the last two may be left out. Throws InputError for wrong values and for a camera
/// without a frame.
ViewState read_view_state(const JsonNode& node);

}  // namespace pellucid::view
