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

/// Returns the text of a study file with another camera behind those of its `views`, or with these
/// made of it; all else stays as it is. Throws InputError for views that are a number or "path",
/// and for what is no object of JSON.
std::string with_view(const std::string& file, const std::string& text,
                      const scene::Camera& camera);

/// Writes the camera into a study file, whole or not at all; returns how many views it then has.
/// Throws as with_view(), and as reading and writing a file does.
std::size_t add_view(const std::filesystem::path& file, const scene::Camera& camera);

}  // namespace pellucid::view
