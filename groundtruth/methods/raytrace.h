// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/methods/raytracer.h"

namespace pellucid::groundtruth {

/// Returns the table of RaytraceOptions.
const OptionTable<RaytraceOptions>& raytrace_options();

/// The exact composite by Embree's all-hit traversal.
const scene::MethodRow& raytrace_method();

}  // namespace pellucid::groundtruth
