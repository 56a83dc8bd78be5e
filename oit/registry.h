// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "scene/renderer.h"

namespace pellucid::oit {

/// The order-independent methods, one row each; they render by OpenGL 4.5 core.
std::span<const scene::MethodRow> oit_methods();

}  // namespace pellucid::oit
