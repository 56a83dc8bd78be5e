// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scene/view/camera.h"

namespace pellucid::scene {

/// A ForeignCamera is a camera in a file of another program: "view.pvcc", or "state.pvsm:2", the
/// second of several.
struct ForeignCamera {
  std::filesystem::path file;
  std::optional<int> number;  // from 1 on; none: the only one
};

/// Returns ".pvcc, .pvsm, …": what such files end in.
std::string foreign_camera_endings();

/// Returns which camera of a file `text` names; nothing when it does not end as such files do.
/// Throws InputError for a number that is none.
std::optional<ForeignCamera> foreign_camera(std::string_view text);

/// Reads the camera; `base` is where a relative path starts. That of a glTF file has its target one
/// world unit ahead. Throws InputError for a file that cannot be read, that has none, or several
/// where none is chosen.
Camera read_foreign_camera(const ForeignCamera& from, const std::filesystem::path& base);

}  // namespace pellucid::scene
