#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "geometry/triangle_mesh.h"
#include "scene/isosurface.h"
#include "scene/json_node.h"

namespace pellucid {

/// The value of an object's key "isosurface", as a surface or, where it says "mesh", as triangles
/// on it. `how` gets a line on the field. Throws InputError.
std::variant<Isosurface, TriangleMesh> read_isosurface(const JsonNode& node,
                                                       const std::filesystem::path& folder,
                                                       std::string& how);

}  // namespace pellucid
