// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/files/json_node.h"
#include "geometry/vertices.h"
#include "scene/view/radii.h"

namespace pellucid::scene {

/// Returns the scalar that an object's key "radius" is by, if it has one.
std::optional<std::string> scalar_of_radius(const JsonNode& object);

/// Reads the key "radius" of an object with these vertices: a length above 0, or a scalar of the
/// vertices times a scale, none below 0 and one above it. Throws InputError that names file, key,
/// scalar, the first vertex that has another, and what is accepted.
Radii read_radii(const JsonNode& object, const geometry::Vertices& vertices);

}  // namespace pellucid::scene
