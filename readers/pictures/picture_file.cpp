// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pictures/picture_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "core/error.h"
#include "core/files/child_reader.h"
#include "core/files/output_file.h"
#include "readers/pictures/of_picture.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;

/// The program for the format that the first bytes tell.
std::string_view program_for(const fs::path& path) {
  std::array<char, 4> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  const std::string_view mark(begin.data(), begin.size());
  const bool quickly = mark == "\x76\x2f\x31\x01" || mark == "\x89PNG";
  return quickly ? "pellucid-read-picture" : "pellucid-read-oiio";
}

PictureWindow window_of(std::span<const std::int32_t> numbers) {
  const PictureWindow window{numbers[0], numbers[1], numbers[2], numbers[3]};
  if (window.width < 1 || window.height < 1 || window.pixels() > max_picture_pixels)
    throw BlockError("a window without pixels, or of too many");
  return window;
}

std::vector<Block> channels_of(const Blocks& blocks, const PictureWindow& data) {
  std::vector<Block> channels;
  for (Block block : blocks.all()) {
    if (!block.name.starts_with(channel_prefix)) continue;
    const bool is_number = block.type == NumberType::f32 || block.type == NumberType::u32;
    if (!is_number || block.components != 1 || block.tuples != std::uint64_t(data.pixels()))
      block.fail("is no value per pixel");
    block.name.erase(0, channel_prefix.size());
    channels.push_back(std::move(block));
  }
  return channels;
}

PictureFile picture_of(Blocks blocks) {
  const auto windows = blocks.at("window").values<std::int32_t>();
  if (windows.size() != 8) blocks.at("window").fail("does not hold two windows");
  const PictureWindow data = window_of(windows.first(4)), picture = window_of(windows.last(4));
  std::vector<Block> channels = channels_of(blocks, data);
  std::string text = blocks.text("text");
  return {data, picture, std::move(text), std::move(channels), std::move(blocks)};
}

/// A picture that is nearly all of one colour is a small file: memory for all the values it may
/// hold, as the library reads them and as they are left, but not for more than four channels.
std::uint64_t memory_for(const fs::path& path) {
  constexpr std::uint64_t bytes_per_value = 2 * sizeof(float), libraries = std::uint64_t(1) << 30;
  const std::uint64_t most = 4 * max_picture_pixels;
  return libraries + bytes_per_value * std::min<std::uint64_t>(
                                           most, max_picture_compression * fs::file_size(path));
}

Blocks blocks_of(const fs::path& path, const std::vector<std::string>& what) {
  require_file(path);
  return read_in_child(program_for(path), path, what, memory_for(path));
}

}  // namespace

PictureFile read_picture_file(const fs::path& path) {
  return of_picture(path, [&] { return picture_of(blocks_of(path, {})); });
}

std::string read_picture_text(const fs::path& path, const std::string& attribute) {
  return of_picture(path, [&] { return blocks_of(path, {"text", attribute}).text("text"); });
}

}  // namespace pellucid::readers
