// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>

#include "readers/pictures/parse_picture.h"

namespace pellucid::readers {
namespace {

/// OpenImageIO takes "?key=value" in a name for arguments: such a file it gets by its descriptor.
std::string plain_name(const std::filesystem::path& path) {
  const bool is_plain = path.string().find('?') == std::string::npos;
  return is_plain ? path.string() : fmt::format("/proc/self/fd/{}", ::open(path.c_str(), O_RDONLY));
}

std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path) {
  OIIO::ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);  // the colours as they are stored
  auto input = OIIO::ImageInput::open(plain_name(path), &wish);
  if (!input) cannot_read_picture(path, OIIO::geterror());
  return input;
}

/// Row by row: where OpenImageIO 2.4 reads a TIFF file's strips at once, one that is cut off is 0
/// and no error.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, std::vector<float>& values) {
  const std::size_t row = std::size_t(spec.width) * std::size_t(spec.nchannels);
  for (int y = 0; y < spec.height; ++y)
    if (!input.read_scanline(spec.y + y, 0, OIIO::TypeDesc::FLOAT, &values[std::size_t(y) * row]))
      return false;
  return true;
}

std::vector<float> read_values(OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                               const std::filesystem::path& path) {
  std::vector<float> values(std::size_t(spec.width) * std::size_t(spec.height) *
                            std::size_t(spec.nchannels));
  const bool is_tiled = spec.tile_width > 0;
  const bool done =
      is_tiled ? input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())
               : read_rows(input, spec, values);
  if (!done) cannot_read_picture(path, input.geterror());
  return values;
}

std::vector<float> channel_of(const std::vector<float>& interleaved, std::size_t channels,
                              std::size_t number) {
  std::vector<float> values(interleaved.size() / channels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = interleaved[i * channels + number];
  return values;
}

}  // namespace

void parse_by_openimageio(const std::filesystem::path& path, BlockWriter& out) {
  const auto input = open_picture(path);
  const OIIO::ImageSpec spec = input->spec();
  if (spec.deep) cannot_read_picture(path, "it is deep; accepted: one sample per pixel");
  const PictureWindow data{spec.x, spec.y, spec.width, spec.height},
      whole{spec.full_x, spec.full_y, spec.full_width, spec.full_height};
  check_picture_size(path, data, whole, std::size_t(std::max(spec.nchannels, 0)));
  const std::vector<float> values = read_values(*input, spec, path);
  write_windows(data, whole, out);
  for (std::size_t i = 0; i < spec.channelnames.size(); ++i)
    write_channel(spec.channelnames[i], channel_of(values, spec.channelnames.size(), i), out);
}

}  // namespace pellucid::readers
