// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Parses the particles of a snapshot in HDF5, as GADGET, AREPO, GIZMO and SWIFT write it: groups
/// PartType0, PartType1, … with a data set Coordinates (particles × 3). It writes the particles of
/// all types, type after type, as `positions` (f64 × 3, in the file's units) and a block
/// `column:NAME` (f64 × components) per data set of numbers; a type that lacks it has NaN there. Of
/// several types `column:particle_type` is the number; a mass that the head keeps for a whole type
/// is in `column:Masses`. The block `remarks` says what was left out, a line each. Throws
/// InputError that names `path` for what is no such snapshot, and for data sets that are kept in
/// other files.
void parse_snapshot(const std::filesystem::path& path, BlockWriter& out);

}  // namespace pellucid::readers
