// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/renderer.h"

namespace pellucid::groundtruth {

/// Isosurfaces by ray marching, as published; everything else as in `raytrace`.
const scene::MethodRow& march_method();

}  // namespace pellucid::groundtruth
