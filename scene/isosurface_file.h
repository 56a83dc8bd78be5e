#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "geometry/triangle_mesh.h"
#include "scene/appearance.h"
#include "scene/isosurface.h"
#include "scene/json_node.h"

namespace pellucid {

/// The value of an object's key "isosurface", as a surface or, where it says "mesh", as triangles
/// on it. `color` is by a scalar of the same data; without a range of its own that of the samples
/// is mapped. `how` gets a line on the field. Throws InputError.
std::variant<Isosurface, TriangleMesh> read_isosurface(const JsonNode& node,
                                                       const std::filesystem::path& folder,
                                                       const std::optional<ScalarColor>& color,
                                                       std::string& how);

}  // namespace pellucid
