// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/raster.h"

namespace pellucid::compare {

// 32-bit words of a picture as the report's page reads them (page/viewer/pixels.js): small, since
// neighbours and methods are alike, and exact.

/// Returns what is left of each word beside its prediction, in base64: the differences modulo 2^32,
/// their highest bytes first, then all second ones, and so on, compressed by zlib (RFC 1950). A
/// word's prediction is the one at its place in `predicted`, which has as many, or where that is
/// empty the word before it.
std::string packed_words(std::span<const std::uint32_t> words,
                         std::span<const std::uint32_t> predicted = {});

/// Returns the bits of a picture's floats, all red ones, then green, then blue, each rounded to the
/// nearest number of `mantissa_bits` (23: as it is).
std::vector<std::uint32_t> color_words(const Image& image, int mantissa_bits);

}  // namespace pellucid::compare
