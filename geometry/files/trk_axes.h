// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/vec.h"
#include "geometry/files/byte_reader.h"

namespace pellucid::geometry {

/// A TrkImage is what the header of a .trk file says of the image that its tracks are in.
struct TrkImage {
  Vec3 voxel_size{1};         // mm
  std::array<int, 3> size{};  // voxels
  Mat4 ras_from_voxel{1};     // mm; [3][3] is 0 where the file does not say
  std::string voxel_order;    // "LPS": to where the axes of the file's voxels run; empty is LPS
};

/// Returns what brings coordinates of the file to scanner coordinates (RAS, mm), as nibabel does;
/// appends what it took for granted to `remarks`. Throws InputError for sizes that are not above 0,
/// a matrix without an inverse, and a voxel order that is none.
Mat4 ras_from_trk(const TrkImage& image, const ByteReader& bytes,
                  std::vector<std::string>& remarks);

}  // namespace pellucid::geometry
