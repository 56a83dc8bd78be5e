#pragma once

#include <span>

#include "scene/renderer.h"

namespace pellucid {

/// The order-independent methods, one row each; they render by OpenGL 4.5 core.
std::span<const MethodRow> oit_methods();

}  // namespace pellucid
