// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for vdb_field.cpp alone.

#include <array>
#include <filesystem>

#include "readers/vdb/grid_blocks.h"

namespace pellucid::fields {

/// Returns a grid of vectors whose components along x, y and z are the values of three grids:
/// active where one of them is, and there each has its background where it is not active itself.
/// Throws InputError, naming `path`, for grids that are not all of float or all of double, and for
/// such that are not at the same places.
openvdb::GridBase::Ptr joined_components(const std::array<const readers::VdbGrid*, 3>& grids,
                                         const std::filesystem::path& path);

}  // namespace pellucid::fields
