// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "fields/levels/exact_levels.h"
#include "fields/levels/value_gaps.h"

namespace pellucid::readers {
struct VdbGrid;
}

namespace pellucid::fields {

/// Makes a level of every grid that has the scalar: scalar grids of that name (float or double), or
/// else, for a derived scalar, the grids of the `velocity`, which choose_velocity() finds when it
/// is empty, at_centres() when they are staggered. Of a level set or a fog volume the level is the
/// box around its active voxels. `path` names the grids' file in messages. Throws InputError where
/// there is no such grid, and for a grid of another class whose active voxels do not fill a box,
/// whose voxels are not cubes along the world's axes, or that check_level() refuses. Grids that
/// became levels are empty afterwards, but level sets, so that no voxel is in memory twice.
ExactLevels levels_of(std::span<const readers::VdbGrid> grids, const std::filesystem::path& path,
                      std::string_view scalar, std::string_view velocity = {});

/// Returns the least and the largest value of such levels of a scalar: of level sets that of their
/// active voxels, since beyond its narrow band a level set has the band's width; else a sample's.
Vec2 value_range(std::span<const readers::VdbGrid> grids, std::string_view scalar,
                 const ExactLevels& levels);

/// Returns the values of which no such level of a scalar has a right surface: those that it would
/// pass beyond the narrow band of a level set (add_gaps_beyond_band()); none of other grids.
ValueGaps value_gaps(std::span<const readers::VdbGrid> grids, std::string_view scalar);

/// Writes each level as a grid of that name whose active voxels are its samples, in one file, which
/// appears whole or not at all: read again, every bit is as it was. Throws InputError for another
/// ending than .vdb, no level, or one that check_level() refuses; WorkError when OpenVDB cannot
/// write; and as OutputFile does.
///@{
void write_vdb_levels(const std::filesystem::path& path, const std::string& name,
                      std::span<const ScalarLevel> levels);
void write_vdb_levels(const std::filesystem::path& path, const std::string& name,
                      std::span<const VectorLevel> levels);
///@}

}  // namespace pellucid::fields
