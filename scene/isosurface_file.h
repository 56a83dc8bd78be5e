#pragma once

#include <filesystem>
#include <string>

#include "scene/isosurface.h"
#include "scene/json_node.h"

namespace pellucid {

/// The value of an object's key "isosurface". `how` gets a line on the field. Throws InputError.
Isosurface read_isosurface(const JsonNode& node, const std::filesystem::path& folder,
                           std::string& how);

}  // namespace pellucid
