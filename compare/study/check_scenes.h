// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/study/study.h"
#include "core/files/json_node.h"

namespace pellucid::compare {

/// Holds what a study says of its scenes' pictures to the scenes' heads, before any object
/// is read. `root` is the study's file. Throws InputError for a crop or a probe that is not within
/// its scene's picture, for a path of views where a scene has none, and for a reference_scene of
/// another background or camera than its scene's: errors would be those of two different views.
/// Cameras that are fitted to objects are not known yet.
void check_scenes(const JsonNode& root, const Study& study);

}  // namespace pellucid::compare
