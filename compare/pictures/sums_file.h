// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exact sums as OpenEXR files.

#include <filesystem>
#include <functional>
#include <vector>

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {

/// Writes a channel of 32-bit float for every member of PixelSums, under its name. Throws
/// InputError for an ending other than .exr or a folder that cannot be written, WorkError when the
/// disk is full.
void write_sums(const std::filesystem::path& path, const Raster<groundtruth::PixelSums>& sums);

/// Writes a deep picture: every crossing of the ray through a pixel's centre is a sample, front to
/// back, of R, G, B (multiplied by alpha), A, Z (view depth, world units), importance (g), all
/// 32-bit float, and object and primitive, 32-bit integers. `row` gives a row's rays; rows are
/// asked for from the top, and no more than one is kept. Throws as write_sums.
void write_deep(const std::filesystem::path& path, int width, int height,
                const std::function<std::vector<groundtruth::RaySums>(int y)>& row);

}  // namespace pellucid::compare
