// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/image_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "compare/pictures/exr_file.h"
#include "compare/pictures/png_file.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"
#include "readers/pictures/picture_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using readers::PictureFile;

constexpr const char* layers_channel = "layers";

/// The values of a file's channel: what was stored as an integer is made float.
class Channel {
 public:
  explicit Channel(const Block& block) : block_(block) {}
  float operator[](std::size_t pixel) const {
    return block_.type == NumberType::u32 ? float(block_.values<std::uint32_t>()[pixel])
                                          : block_.values<float>()[pixel];
  }

 private:
  const Block& block_;
};

/// Which of a file's channels are what.
struct ChannelPlan {
  int color[3];  // red, green, blue
  int alpha;     // or -1: opaque
};

/// "R" and "beauty.R" are R.
std::string last_name(const std::string& channel) { return channel.substr(channel.rfind('.') + 1); }

/// "beauty." of "beauty.R"; empty of "R", which is of no layer.
std::string layer_of(const std::string& channel) {
  return channel.substr(0, channel.rfind('.') + 1);
}

/// The layer's channel of one of these names; -1 where there is none.
int find_channel(const PictureFile& file, const std::string& layer,
                 std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < file.channels.size(); ++i) {
    const std::string& name = file.channels[i].name;
    if (layer_of(name) == layer && std::ranges::find(names, last_name(name)) != names.end())
      return int(i);
  }
  return -1;
}

int find_alpha(const PictureFile& file, const std::string& layer) {
  return find_channel(file, layer, {"A", "a", "alpha"});
}

/// The layer's red, green and blue, if it has all three. None is another layer's.
std::optional<ChannelPlan> colors_of(const PictureFile& file, const std::string& layer) {
  const int red = find_channel(file, layer, {"R", "r", "red"}),
            green = find_channel(file, layer, {"G", "g", "green"}),
            blue = find_channel(file, layer, {"B", "b", "blue"});
  if (red < 0 || green < 0 || blue < 0) return std::nullopt;
  return ChannelPlan{{red, green, blue}, find_alpha(file, layer)};
}

[[noreturn]] void refuse_channels(const PictureFile& file, const fs::path& path) {
  std::vector<std::string> names;
  for (const Block& channel : file.channels) names.push_back(channel.name);
  throw InputError(
      fmt::format("{}: cannot read the picture: its channels are {}; accepted: R G B, "
                  "Y, each with or without A and of one layer, or one of any name",
                  path.string(), fmt::join(names, ", ")));
}

/// Colours of no layer come before those of the only layer that has some.
ChannelPlan plan_channels(const PictureFile& file, const fs::path& path) {
  if (const auto plan = colors_of(file, "")) return *plan;
  std::set<std::string> layers;
  for (const Block& channel : file.channels)
    if (colors_of(file, layer_of(channel.name))) layers.insert(layer_of(channel.name));
  if (layers.size() > 1) refuse_channels(file, path);
  if (layers.size() == 1) return *colors_of(file, *layers.begin());
  const std::string layer = file.channels.empty() ? "" : layer_of(file.channels[0].name);
  const int grey = find_channel(file, layer, {"Y", "y"}), alpha = find_alpha(file, layer);
  const bool is_grey = grey >= 0 && file.channels.size() == 1u + (alpha >= 0);
  if (is_grey) return {{grey, grey, grey}, alpha};
  if (file.channels.size() == 1) return {{0, 0, 0}, -1};
  refuse_channels(file, path);
}

/// Pixels of the picture's window that the data leave out are 0, as OpenEXR has it.
template <class T, class Pixel>
Raster<T> place(const PictureFile& file, const Pixel& pixel_of) {
  const readers::PictureWindow &data = file.data, &window = file.picture;
  Raster<T> picture(window.width, window.height, T(0));
  for (int y = 0; y < data.height; ++y)
    for (int x = 0; x < data.width; ++x) {
      const std::int64_t column = std::int64_t(data.x) + x - window.x,
                         row = std::int64_t(data.y) + y - window.y;
      if (column < 0 || column >= window.width || row < 0 || row >= window.height) continue;
      picture.pixels[std::size_t(row * window.width + column)] =
          pixel_of(std::size_t(y) * std::size_t(data.width) + std::size_t(x));
    }
  return picture;
}

[[noreturn]] void refuse_counts(const fs::path& path) {
  throw InputError(
      fmt::format("{}: holds no numbers of layers; accepted: one channel, '{}', of whole numbers",
                  path.string(), layers_channel));
}

bool is_count(float value) {
  constexpr float most = 4294967040.f;  // the largest float below 2^32
  return value >= 0 && value <= most && value == std::floor(value);
}

/// True for .exr, false for .png.
bool is_exr(const fs::path& path) {
  const std::string ending = small_ending(path);
  if (ending != ".exr" && ending != ".png")
    throw InputError(fmt::format("{}: ending '{}'; accepted: .exr, .png", path.string(),
                                 path.extension().string()));
  return ending == ".exr";
}

/// Colour without the alpha that it is multiplied by; nothing has none.
Rgba straight(const Rgba& pixel) {
  return pixel.a > 0 ? Rgba(glm::vec3(pixel) / pixel.a, pixel.a) : Rgba(0);
}

std::vector<std::uint8_t> to_bytes(const Image& image, bool is_premultiplied) {
  const int channels = is_premultiplied ? 4 : 3;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * std::size_t(channels));
  for (const Rgba& pixel : image.pixels) {
    const Rgba written = is_premultiplied ? straight(pixel) : pixel;
    for (int c = 0; c < channels; ++c) bytes.push_back(displayed_byte(written[c]));
  }
  return bytes;
}

}  // namespace

Image read_image(const fs::path& path) { return read_picture(path).image; }

PictureRead read_picture(const fs::path& path) {
  const PictureFile file = readers::read_picture_file(path);
  const ChannelPlan plan = plan_channels(file, path);
  const auto channel = [&](int number) { return Channel(file.channels[std::size_t(number)]); };
  const Channel red = channel(plan.color[0]), green = channel(plan.color[1]),
                blue = channel(plan.color[2]), alpha = channel(std::max(plan.alpha, 0));
  const auto pixel = [&](std::size_t i) {
    return Rgba(red[i], green[i], blue[i], plan.alpha >= 0 ? alpha[i] : 1);
  };
  return {place<Rgba>(file, pixel), plan.alpha >= 0};
}

CountImage read_counts(const fs::path& path) {
  const PictureFile file = readers::read_picture_file(path);
  if (file.channels.size() != 1) refuse_counts(path);
  if (file.channels[0].type == NumberType::u32) {
    const auto counts = file.channels[0].values<std::uint32_t>();
    return place<std::uint32_t>(file, [&](std::size_t i) { return counts[i]; });
  }
  const auto counts = file.channels[0].values<float>();
  const bool are_layers = last_name(file.channels[0].name) == layers_channel;  // and no mask
  if (!are_layers || !std::ranges::all_of(counts, is_count)) refuse_counts(path);
  return place<std::uint32_t>(file, [&](std::size_t i) { return std::uint32_t(counts[i]); });
}

void write_image(const fs::path& path, const Image& image, const PictureForm& form) {
  if (is_exr(path))
    return write_text(path, encode_exr(path, image.width, image.height, {"R", "G", "B", "A"},
                                       Imf::FLOAT, image.pixels.data(), text_of_exr(form)));
  write_text(path, encode_png(path, image, form));
}

std::string encode_png(const fs::path& path, const Image& image, const PictureForm& form) {
  return encode_png(path, image.width, image.height, form.is_premultiplied ? 4 : 3,
                    to_bytes(image, form.is_premultiplied), text_of_png(form));
}

void write_counts(const fs::path& path, const CountImage& counts, const PictureForm& picture) {
  if (is_exr(path)) {
    const std::vector<float> values(counts.pixels.begin(), counts.pixels.end());
    return write_text(path,
                      encode_exr(path, counts.width, counts.height, {layers_channel}, Imf::FLOAT,
                                 values.data(), text_beside(picture, "layers per pixel")));
  }
  std::vector<std::uint8_t> bytes(counts.pixels.size());
  std::transform(counts.pixels.begin(), counts.pixels.end(), bytes.begin(),
                 [](std::uint32_t n) { return std::uint8_t(std::min<std::uint32_t>(n, 255)); });
  write_text(path, encode_png(path, counts.width, counts.height, 1, bytes,
                              text_beside(picture, "layers per pixel, 255 at most")));
}

std::uint8_t displayed_byte(float value) {
  if (!(value > 0)) return 0;  // NaN too
  // Of a value >= 0, the nearest. NOLINTNEXTLINE(bugprone-incorrect-roundings)
  return std::uint8_t(std::min(value, 1.f) * 255 + 0.5f);
}

Image displayed_values(const Image& image) {
  Image shown = image;
  for (Rgba& pixel : shown.pixels)
    for (int c = 0; c < 4; ++c) pixel[c] = displayed_byte(pixel[c]) / 255.f;
  return shown;
}

}  // namespace pellucid::compare
