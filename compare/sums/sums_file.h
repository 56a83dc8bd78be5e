// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a method has summed up over a part of a scene, as a file, and what all parts add up to.

#include <filesystem>
#include <string>

#include "compare/deep/deep_info.h"
#include "core/raster.h"
#include "scene/parts/partial_sums.h"
#include "scene/view_depth.h"

namespace pellucid::compare {

/// A SumsInfo says what sums are of.
struct SumsInfo {
  DeepInfo of;             // the picture, and which part; of the totals of all parts part 1 of 1
  std::string scene_file;  // absolute, so that its parts can be drawn again
  std::string method;      // its call: "fourier:bands=5"
  int phase = 1;           // of the method, from 1 …
  int phases = 1;          // … of so many
  scene::DepthRange depths;
};

/// A SumsFile holds the sums of one phase of a method over a part of a scene.
struct SumsFile {
  SumsInfo info;
  scene::SumPlanes planes;
  Image behind;  // see scene::PartialSums::behind()
};

/// Writes sums as an OpenEXR file: a channel of 32-bit float, compressed (ZIP), for each number of
/// each plane and for `behind`. The header says in JSON what they are. Throws InputError for an
/// ending other than .exr or a folder that cannot be written, WorkError when the disk is full.
void write_sums_file(const std::filesystem::path& path, const SumsFile& sums);

/// Reads what a file of sums says of itself. Throws InputError that names it when it is missing,
/// damaged or none.
SumsInfo read_sums_info(const std::filesystem::path& path);

/// Reads a file of sums. Throws as read_sums_info() does.
SumsFile read_sums_file(const std::filesystem::path& path);

}  // namespace pellucid::compare
