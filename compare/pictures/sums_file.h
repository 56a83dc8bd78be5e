// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exact sums as OpenEXR files.

#include <filesystem>

#include "compare/pictures/picture_text.h"
#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {

/// Writes a channel of 32-bit float for every member of PixelSums, under its name; what
/// they are of is what the picture is of. Throws InputError for an ending other than .exr or a
/// folder that cannot be written, WorkError when the disk is full.
void write_sums(const std::filesystem::path& path, const Raster<groundtruth::PixelSums>& sums,
                const PictureForm& picture);

}  // namespace pellucid::compare
