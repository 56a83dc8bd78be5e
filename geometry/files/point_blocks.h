// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/blocks.h"
#include "geometry/point_set.h"

namespace pellucid::geometry {

/// Returns the points whose `positions` and columns the blocks hold, as parse_vdb_points() and
/// parse_snapshot() of readers/ write them: columns of one number are scalars of their name, others
/// one scalar a component (component_suffix()); lines of `remarks` become remarks. Throws
/// BlockError for positions that are not three numbers, and for a column of another length.
PointSet points_of(const Blocks& blocks);

}  // namespace pellucid::geometry
