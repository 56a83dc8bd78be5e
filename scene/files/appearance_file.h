// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/json_node.h"
#include "scene/appearance/appearance.h"
#include "scene/appearance/lighting.h"

namespace pellucid::scene {

/// Reads a colour: [red, green, blue] in [0, 1], or a text that color_of_text() takes.
Vec3 read_rgb(const JsonNode& node);

/// Reads one of the lighting_names.
Lighting read_lighting(const JsonNode& node);

/// Reads the keys color, opacity and importance of an object; a colour map's file starts at
/// `folder`.
Appearance read_appearance(const JsonNode& node, const std::filesystem::path& folder);

}  // namespace pellucid::scene
