// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/json_node.h"
#include "scene/view/camera.h"
#include "scene/view/pixel_samples.h"

namespace pellucid::scene {

/// Reads {"type", "eye", "target", "up", "fov" or "height"}, with the defaults of Camera. Throws
/// InputError for other keys and values, but not for a camera without a frame (camera_frame()).
Camera read_camera(const JsonNode& node);

/// Reads the same, or the camera of another program's file that a text names (foreign_camera());
/// `folder` is where a relative path starts. Throws InputError likewise.
Camera read_camera(const JsonNode& node, const std::filesystem::path& folder);

/// Reads {"frames", "orbit" or "keys"}: an orbit starts at the camera; every key is changed by what
/// `change` sets, as camera_of_text() takes it; `folder` is where relative paths start. Throws
/// InputError for other keys and values, and for a camera without a frame.
std::vector<Camera> read_camera_path(const JsonNode& node, const std::filesystem::path& folder,
                                     const Camera& camera, std::string_view change);

/// Returns the camera as a scene file has it.
nlohmann::ordered_json camera_json(const Camera& camera);

/// Returns a pixel's samples as a scene file has them: n, or {"frames": n}.
nlohmann::ordered_json samples_json(const PixelSampling& sampling);

/// Returns the camera as --camera takes it: "eye=0,0,5,target=0,0,0,up=0,1,0,fov=45"; every number
/// reads back as the same.
std::string camera_text(const Camera& camera);

/// Returns `camera` with what such a text sets: any of eye, target and up, and of fov (perspective)
/// and height (orthographic) one, which also says the projection. A text that foreign_camera()
/// takes is another camera altogether, its path from the working folder on. Throws InputError for
/// another key, for what is no finite number and as read_foreign_camera() does; camera_frame()
/// refuses what sees nothing.
Camera camera_of_text(std::string_view text, Camera camera);

/// Says whether such a text sets the eye. Throws InputError as camera_of_text() does for another
/// key.
bool sets_eye(std::string_view text);

}  // namespace pellucid::scene
