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

/// Reads the value of an object's key "isosurface", as a surface or, where it says "mesh", as
/// triangles on it. A colour or an opacity by a scalar takes one of the same data; its range is, if
/// not given, from the least to the largest sample. The rest of the appearance is not applied.
/// `how` gets a line on the field. Throws InputError for a wrong key or value, a file or a data set
/// that cannot be used, and a surface without a triangle.
std::variant<Isosurface, geometry::TriangleMesh> read_isosurface(
    const JsonNode& node, const std::filesystem::path& folder, const Appearance& appearance,
    std::string& how);

/// Gives a surface that read_isosurface() has made the value that `node` says, the colour map and
/// the opacities of `appearance`; their scalars and ranges stay. Throws InputError for a wrong
/// value and an unknown map.
void restyle_isosurface(const Appearance& appearance, const JsonNode& node, Isosurface& surface);

}  // namespace pellucid::scene
