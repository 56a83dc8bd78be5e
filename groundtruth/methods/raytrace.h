// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/renderer.h"

namespace pellucid::groundtruth {

/// The exact composite by Embree's all-hit traversal.
const scene::MethodRow& raytrace_method();

}  // namespace pellucid::groundtruth
