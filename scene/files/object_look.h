// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/files/json_node.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// FileValues are those of a file's scalars, by name, where vertices repeat them.
using FileValues = std::map<std::string, std::vector<double>>;

/// Gives an object that was read the colours, opacities and importance that its node says, and
/// remarks on what the map does not show. Throws InputError that names the node.
void apply_look(const JsonNode& node, const std::filesystem::path& folder, const FileValues& values,
                SceneObject& object);

/// Returns whether the look is by percentiles of a file's values, which vertices may repeat.
bool asks_percentiles_of_file(const JsonNode& node, const std::filesystem::path& folder);

}  // namespace pellucid::scene
