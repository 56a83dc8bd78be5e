// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/parts/scene_part.h"

namespace pellucid::app {

/// Returns the part that --part I/N asks for. Throws InputError for another text.
scene::PartNumber part_number_of(const std::string& text);

}  // namespace pellucid::app
