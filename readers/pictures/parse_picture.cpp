// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pictures/parse_picture.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::readers {

void cannot_read_picture(const std::filesystem::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), why));
}

void check_picture_size(const std::filesystem::path& path, const PictureWindow& data,
                        const PictureWindow& picture, std::size_t channels) {
  const bool too_few =
      data.width < 1 || data.height < 1 || picture.width < 1 || picture.height < 1 || channels == 0;
  if (too_few || data.pixels() > max_picture_pixels || picture.pixels() > max_picture_pixels)
    cannot_read_picture(path, fmt::format("{}×{} pixels; accepted: 1 … {}", picture.width,
                                          picture.height, max_picture_pixels));
  const std::uintmax_t bytes = std::filesystem::file_size(path);
  if (double(data.pixels()) * double(channels) > double(max_picture_compression) * double(bytes))
    cannot_read_picture(
        path, fmt::format("it claims {}×{} pixels in {} bytes", data.width, data.height, bytes));
}

void write_windows(const PictureWindow& data, const PictureWindow& picture, BlockWriter& out) {
  const std::int32_t numbers[] = {data.x,    data.y,    data.width,    data.height,
                                  picture.x, picture.y, picture.width, picture.height};
  out.add("window", std::span<const std::int32_t>(numbers), 4);
}

void write_channel(std::string_view name, std::span<const float> values, BlockWriter& out) {
  out.add(std::string(channel_prefix).append(name), values);
}

}  // namespace pellucid::readers
