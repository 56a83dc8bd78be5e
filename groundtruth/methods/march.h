#pragma once

#include "scene/renderer.h"

namespace pellucid {

/// Isosurfaces by ray marching, as published; everything else as in `raytrace`.
const MethodRow& march_method();

}  // namespace pellucid
