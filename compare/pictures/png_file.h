// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace pellucid::compare {

/// Returns a PNG file of `width` × `height` pixels, row 0 on top, of one (grey) or three (red,
/// green, blue) bytes each. Throws WorkError that names `path`.
std::string encode_png(const std::filesystem::path& path, int width, int height, int channels,
                       std::span<const std::uint8_t> bytes);

}  // namespace pellucid::compare
