// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures as the programs that parse them leave them, as blocks:
//
//     window          i32 × 4, twice: x, y, width, height of the data, then of the picture; pixels
//     text            what an OpenEXR file of partial sums says of itself; no others have it
//     channel:NAME    of each channel: a value per pixel of the data, row by row from the top; f32
//     as
//                     it is stored (n/255 for 8 bits, n/65535 for 16), or u32

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/blocks.h"
#include "readers/pictures/deep_channels.h"

namespace pellucid::readers {

/// A PictureWindow is a rectangle of pixels; y runs down.
struct PictureWindow {
  std::int32_t x = 0, y = 0, width = 0, height = 0;

  std::int64_t pixels() const { return std::int64_t(width) * height; }
};

/// Pixels of the largest picture that is read.
constexpr std::int64_t max_picture_pixels = std::int64_t(1) << 28;
/// Values per byte of the file: the best compressors make pictures some thousand times smaller.
constexpr std::int64_t max_picture_compression = 8192;
/// What the names of the channels' blocks begin with.
constexpr std::string_view channel_prefix = "channel:";

/// A PictureFile holds a picture's channels as they are stored: alpha not multiplied in, no
/// transfer curve.
struct PictureFile {
  PictureWindow data;           // where the channels have values
  PictureWindow picture;        // what is shown, of which the data may leave pixels out
  std::string text;             // of sums of a part of a scene: what they are; else empty
  std::vector<Block> channels;  // by their names in the file
  Blocks blocks;                // what the channels' values lie in
};

/// Reads one of the texts that an OpenEXR file holds, PictureFile::text by default; "" where it has
/// none of that name. Throws as read_picture_file() does.
std::string read_picture_text(const std::filesystem::path& path,
                              const std::string& attribute = deep_attribute);

/// Reads a picture of any format that OpenImageIO knows; OpenEXR and PNG by their own libraries,
/// since OpenImageIO takes a third of a second to load. Throws InputError that names the file when
/// it is missing, damaged, deep, without pixels, of more than max_picture_pixels or of more than
/// its bytes can hold.
PictureFile read_picture_file(const std::filesystem::path& path);

}  // namespace pellucid::readers
