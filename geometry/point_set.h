#pragma once

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// Points that nothing joins.
struct PointSet : Vertices {};

}  // namespace pellucid::geometry
