// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/json_node.h"
#include "scene/transform.h"

namespace pellucid::scene {

/// Reads the keys scale, rotate and translate of an object's transform.
Transform read_transform(const JsonNode& node);

}  // namespace pellucid::scene
