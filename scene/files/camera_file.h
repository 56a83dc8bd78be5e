// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/files/json_node.h"
#include "scene/view/camera.h"

namespace pellucid::scene {

/// Reads {"type", "eye", "target", "up", "fov" or "height"}, with the defaults of Camera. Throws
/// InputError for other keys and values, but not for a camera without a frame (camera_frame()).
Camera read_camera(const JsonNode& node);

/// Reads {"frames", "orbit" or "keys"}: an orbit starts at the camera. Throws InputError for other
/// keys and values, and for a camera without a frame.
std::vector<Camera> read_camera_path(const JsonNode& node, const Camera& camera);

}  // namespace pellucid::scene
