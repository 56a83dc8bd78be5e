// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Deep pictures as the program that parses them leaves them, as blocks. Of the head:
//
//     size            i32 × 2: width and height, pixels
//     text            what the picture says of itself
//     samples         u64: how many samples each row has, from the top
//
// and of some rows:
//
//     counts          u32: how many samples each pixel has, row by row
//     exact.…         f64: see deep_channels.h; of each sample, pixel by pixel
//     importance      f32, object and primitive u32: the same

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/blocks.h"
#include "readers/pictures/deep_channels.h"

namespace pellucid::readers {

/// A DeepHead is what a deep picture says of itself.
struct DeepHead {
  int width = 0, height = 0;           // pixels
  std::string text;                    // of deep_attribute
  std::vector<std::uint64_t> samples;  // of each row
};

/// DeepSamples are those of some rows, pixel by pixel from the left, row by row from the top.
struct DeepSamples {
  std::span<const std::uint32_t> counts;  // of each pixel
  std::array<std::span<const double>, deep_doubles.size()> doubles;
  std::span<const float> importance;
  std::span<const std::uint32_t> object, primitive;
  Blocks blocks;  // what they lie in
};

/// Returns whether a file says by its first bytes that it is a deep OpenEXR picture.
bool is_deep_picture(const std::filesystem::path& path);

/// Reads the head of a deep picture that render --deep has written, and counts its samples. Throws
/// InputError that names the file when it is missing, damaged, cut off, or no such picture.
DeepHead read_deep_head(const std::filesystem::path& path);

/// Reads the rows first … end - 1 of a deep picture, given its head. Throws as read_deep_head().
DeepSamples read_deep_rows(const std::filesystem::path& path, const DeepHead& head, int first,
                           int end);

}  // namespace pellucid::readers
