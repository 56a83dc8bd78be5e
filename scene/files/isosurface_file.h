// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "core/files/json_node.h"
#include "geometry/triangle_mesh.h"
#include "scene/appearance/appearance.h"
#include "scene/isosurface.h"

namespace pellucid::scene {

/// The value of an object's key "isosurface", as a surface or, where it says "mesh", as triangles
/// on it. Colours and opacities by a scalar are by one of the same data, without a range of their
/// own from the least to the largest sample; the rest of the appearance is not applied. `how` gets
/// a line on the field. Throws InputError.
std::variant<Isosurface, geometry::TriangleMesh> read_isosurface(
    const JsonNode& node, const std::filesystem::path& folder, const Appearance& appearance,
    std::string& how);

}  // namespace pellucid::scene
