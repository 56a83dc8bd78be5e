// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// OpenVDB's reader: for the process that pellucid-read-vdb is, and no other.

#include <filesystem>
#include <string>

#include "core/files/blocks.h"

namespace pellucid::readers {

/// Parses the grids of a .vdb file and writes each as grid_blocks.h says: with its tree when
/// `wanted` is its name, or NAME[I] of several of that name, or several of these with commas
/// between, or empty. Throws InputError, and what OpenVDB does.
void parse_vdb_grids(const std::filesystem::path& path, const std::string& wanted,
                     BlockWriter& out);

/// Parses the points of each point grid of a .vdb file, whatever its codecs, and writes `positions`
/// (f64 × 3, world) and a block `column:NAME` (f64, × 3 for vectors) per attribute of numbers that
/// all points have.
/// Houdini's colour `Cd` becomes the columns red, green and blue. Throws as above.
void parse_vdb_points(const std::filesystem::path& path, BlockWriter& out);

}  // namespace pellucid::readers
