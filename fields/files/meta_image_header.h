// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>

#include "core/files/blocks.h"
#include "core/vec.h"

namespace pellucid::fields {

/// A MetaImageHeader is what the header of a MetaImage says of its samples, in the sense in which
/// MetaIO, the library of ITK and VTK, reads it: True, true, T and 1 are true; TransformMatrix,
/// Rotation and Orientation are names of one matrix, whose first three numbers are the direction of
/// the first axis; Offset, Position and Origin are one place.
struct MetaImageHeader {
  std::array<std::size_t, 3> size{};
  Vec3 origin{0}, spacing{1};      // world units
  std::optional<Mat3> directions;  // of the axes, one a column; none: the world's axes
  NumberType type = NumberType::f32;
  std::size_t channels = 1;  // numbers of a sample
  bool big_endian = false, compressed = false;
  std::string data_file;  // "LOCAL": behind the header
  /// Bytes of the data's file before the data; none: these are its last ones.
  std::optional<std::size_t> skipped = 0;

  std::size_t samples() const { return size[0] * size[1] * size[2]; }  // 10^18 at most
  std::size_t sample_bytes() const { return channels * size_of(type); }
};

/// Reads up to and with the line of ElementDataFile, which is the last. Throws InputError that
/// names the file for what is no header of a three-dimensional image.
MetaImageHeader read_meta_image_header(std::istream& file, const std::filesystem::path& path);

}  // namespace pellucid::fields
