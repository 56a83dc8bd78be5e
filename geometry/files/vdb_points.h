// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/blocks.h"
#include "geometry/point_set.h"

namespace pellucid::geometry {

/// Returns the points whose "positions" and columns the blocks hold (readers/vdb/parse_vdb.h).
/// Throws BlockError for positions that are not three numbers, and for a column of another length.
PointSet points_of(const Blocks& blocks);

}  // namespace pellucid::geometry
