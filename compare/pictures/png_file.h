// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "compare/pictures/picture_text.h"

namespace pellucid::compare {

/// Returns a PNG file of `width` × `height` pixels, row 0 on top, of one (grey), three (red, green,
/// blue) or four bytes (and alpha, not multiplied in) each, with the texts as iTXt. Throws
/// WorkError that names `path`.
std::string encode_png(const std::filesystem::path& path, int width, int height, int channels,
                       std::span<const std::uint8_t> bytes, const PictureText& text);

}  // namespace pellucid::compare
