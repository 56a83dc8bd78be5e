// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/json_node.h"
#include "scene/appearance/appearance.h"

namespace pellucid::scene {

/// Reads the colour map of `color` from what a scene file has as its map: a name, a list of stops,
/// ParaView's JSON, or a file of it (".json"), which starts at `folder`. Stops from 0 to 1 are
/// fractions of the range; others are values of the scalar: its range, unless it has one.
/// ParaView's UseLogScale makes its scale logarithmic. Throws InputError for stops that do not
/// ascend, and for a map of ParaView's in another colour space.
void read_colormap(const JsonNode& node, const std::filesystem::path& folder, ScalarColor& color);

}  // namespace pellucid::scene
