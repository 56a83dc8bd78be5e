#pragma once

#include "scene/renderer.h"

namespace pellucid {

/// The exact composite by Embree's all-hit traversal.
const MethodRow& raytrace_method();

}  // namespace pellucid
