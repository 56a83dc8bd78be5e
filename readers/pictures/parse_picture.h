// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The libraries' readers of pictures: for the processes that pellucid-read-picture and
// pellucid-read-oiio are, and no others.

#include <filesystem>
#include <span>
#include <string_view>

#include "core/files/blocks.h"
#include "readers/pictures/picture_file.h"

namespace pellucid::readers {

/// Parses the first part of an OpenEXR file and writes it as picture_file.h says. Throws
/// InputError, and what OpenEXR does.
void parse_exr(const std::filesystem::path& path, BlockWriter& out);

/// Writes the text that an OpenEXR file has under the name of this attribute, if any, and no more.
/// Throws as parse_exr() does.
void parse_exr_text(const std::filesystem::path& path, const char* attribute, BlockWriter& out);

/// Parses a PNG file by libpng, its palette resolved, and writes it as picture_file.h says. Throws
/// InputError.
void parse_png(const std::filesystem::path& path, BlockWriter& out);

/// Parses a picture of any other format by OpenImageIO and writes it as picture_file.h says. Throws
/// InputError.
void parse_by_openimageio(const std::filesystem::path& path, BlockWriter& out);

/// Throws the InputError that says why.
[[noreturn]] void cannot_read_picture(const std::filesystem::path& path, std::string_view why);

/// Throws InputError unless what a header claims has pixels, at most max_picture_pixels of them,
/// and may be in as many bytes as the file has.
void check_picture_size(const std::filesystem::path& path, const PictureWindow& data,
                        const PictureWindow& picture, std::size_t channels);

/// Writes both windows.
void write_windows(const PictureWindow& data, const PictureWindow& picture, BlockWriter& out);

/// Writes the values of the channel of this name.
void write_channel(std::string_view name, std::span<const float> values, BlockWriter& out);

}  // namespace pellucid::readers
