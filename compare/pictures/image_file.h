// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "compare/pictures/picture_text.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Reads a picture of any format that OpenImageIO knows as float RGBA, values as they are stored
/// (n/255 for 8 bits, alpha not multiplied in, no transfer curve). Its channels are R, G, B by
/// their names, others beside them unseen; Y, or one channel of any name, becomes grey; without A,
/// A = 1. The result has the size of the picture's window; where its data leave pixels out, they
/// are 0. Throws InputError when it is missing, damaged, deep, of other channels, without pixels,
/// of more than 2^28 or of more than its bytes can hold.
Image read_image(const std::filesystem::path& path);

/// A PictureRead is a picture, and whether its file has opacities: where it has none, A = 1 is made
/// up.
struct PictureRead {
  Image image;
  bool has_alpha = true;
};

/// Reads a picture as read_image() does, and throws as it does.
PictureRead read_picture(const std::filesystem::path& path);

/// Writes by the file's ending: .exr holds the four channels in 32-bit float; .png holds red, green
/// and blue in 8 bits without a transfer curve. A PNG of composited colours has no alpha: a viewer
/// would blend them a second time; of premultiplied ones it has, and straight colours. Throws
/// InputError for another ending or a folder that cannot be written, WorkError when the disk is
/// full.
void write_image(const std::filesystem::path& path, const Image& image, const PictureForm& form);

/// Returns the picture as write_image() writes it to a .png; `path` is for messages.
std::string encode_png(const std::filesystem::path& path, const Image& image,
                       const PictureForm& form);

/// Writes numbers of layers: .exr holds one channel of 32-bit floats, exact to 2^24, since common
/// viewers show whole numbers as 0; .png 8-bit grey, capped at 255. What they are of is what the
/// picture beside them is of. Throws as write_image() does.
void write_counts(const std::filesystem::path& path, const CountImage& counts,
                  const PictureForm& picture);

/// Reads what write_counts() has written as .exr, or the same as whole numbers. Throws as
/// read_image() does, and for numbers that count nothing.
CountImage read_counts(const std::filesystem::path& path);

/// Returns the nearest n of the 256 values n/255 that a screen shows; 0 for NaN.
std::uint8_t displayed_byte(float value);

/// Returns the picture with every channel as the nearest n/255.
Image displayed_values(const Image& image);

}  // namespace pellucid::compare
