// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// A PointSet holds points that nothing joins.
struct PointSet : Vertices {};

}  // namespace pellucid::geometry
