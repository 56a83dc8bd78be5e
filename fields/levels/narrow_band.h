// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for what uses .vdb files' grids alone.

#include <openvdb/openvdb.h>

#include "fields/levels/value_gaps.h"

namespace pellucid::fields {

/// Adds the values of which a level set of numbers has no right surface: those that it passes in
/// a cell, within the box of its values (box_of_values()), of which a corner is not active. Beyond
/// its narrow band a level set has the band's width, where the distance goes on. Of another grid
/// there are none.
void add_gaps_beyond_band(const openvdb::GridBase::Ptr& grid, ValueGaps& gaps);

}  // namespace pellucid::fields
