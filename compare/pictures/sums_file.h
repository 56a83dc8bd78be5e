// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exact sums as OpenEXR files.

#include <filesystem>

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {

/// Writes a channel of 32-bit float for every member of PixelSums, under its name. Throws
/// InputError for an ending other than .exr or a folder that cannot be written, WorkError when the
/// disk is full.
void write_sums(const std::filesystem::path& path, const Raster<groundtruth::PixelSums>& sums);

}  // namespace pellucid::compare
