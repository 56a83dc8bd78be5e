// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/progress.h"
#include "groundtruth/traversal/scene_part.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// Reads a scene file, and keeps a part of the scene's primitives. Where it has several objects
/// they are read twice, one at a time: first for the box of them all and the camera that sees them,
/// then to be cut; so that the largest object, and the part, have to find room in memory. A scene
/// with halos, which lie around whole lines, is read as a whole. Throws as load_scene() and
/// take_part() do.
groundtruth::ScenePart load_part(const std::filesystem::path& path, const Progress& progress,
                                 const scene::ViewRequest& view, const scene::PartNumber& part,
                                 scene::PartOf of = scene::PartOf::all_objects);

}  // namespace pellucid::compare
