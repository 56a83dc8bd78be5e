// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/files/json_node.h"
#include "core/progress.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// An ObjectContext is what all objects of a scene file share while they are read.
struct ObjectContext {
  std::filesystem::path folder;  // where relative paths start
  const Progress& progress;
  std::map<std::string, std::string>& provenance;  // gets a line on how the object was made
};

/// Reads or integrates one of a scene file's objects and applies its appearance. Throws InputError
/// that names file, key and accepted values.
SceneObject read_object(const JsonNode& node, const ObjectContext& context);

}  // namespace pellucid::scene
