// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/progress.h"
#include "scene/files/view_request.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// Reads a scene file ("pellucid-scene", version 1), its meshes, and integrates its surfaces.
/// Scene::name is the file's stem; `view` goes before what the file says of the view. Throws
/// InputError that names file, key and accepted values.
Scene load_scene(const std::filesystem::path& path, const Progress& progress = {},
                 const ViewRequest& view = {});

}  // namespace pellucid::scene
