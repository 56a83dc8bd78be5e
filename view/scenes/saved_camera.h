// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "scene/view/camera.h"

namespace pellucid::view {

/// Returns the text of a scene file with another camera; all of it that is not the camera stays as
/// it is, to the last blank. `file` names it in messages. Throws InputError for what is no object
/// of JSON.
std::string with_camera(const std::string& file, const std::string& text,
                        const scene::Camera& camera);

/// Writes the camera into a scene file, whole or not at all. Throws InputError and WorkError as
/// reading and writing a file does.
void save_camera(const std::filesystem::path& file, const scene::Camera& camera);

}  // namespace pellucid::view
