#pragma once

#include "geometry/vertices.h"

namespace pellucid {

/// Points that nothing joins.
struct PointSet : Vertices {};

}  // namespace pellucid
