// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr std::int64_t max_pixels = std::int64_t(1) << 28;  // nothing a header claims gets past it

std::string one_line(std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

[[noreturn]] void cannot_read(const fs::path& path, const std::string& why) {
  throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), one_line(why)));
}

/// libpng prints to stderr what it also returns as an error; only app/ prints.
class SilentStderr {
 public:
  SilentStderr() : saved_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~SilentStderr() {
    if (saved_ < 0) return;
    ::dup2(saved_, STDERR_FILENO);
    ::close(saved_);
  }
  SilentStderr(const SilentStderr&) = delete;
  SilentStderr& operator=(const SilentStderr&) = delete;

 private:
  int saved_;
};

std::unique_ptr<ImageInput> open_input(const fs::path& path) {
  if (!fs::is_regular_file(path)) cannot_read(path, "no such file");
  ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);  // the colours as they are stored
  auto input = ImageInput::open(path.string(), &wish);
  if (!input) cannot_read(path, OIIO::geterror());
  const ImageSpec& spec = input->spec();
  if (spec.deep) cannot_read(path, "it is deep; accepted: one sample per pixel");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 ||
      std::int64_t(spec.width) * spec.height > max_pixels)
    cannot_read(path,
                fmt::format("{}×{} pixels; accepted: 1 … {}", spec.width, spec.height, max_pixels));
  return input;
}

/// The first `channels` channels, interleaved.
template <class T>
std::vector<T> read_channels(ImageInput& input, int channels, TypeDesc type, const fs::path& path) {
  const ImageSpec spec = input.spec();
  std::vector<T> values(std::size_t(spec.width) * spec.height * channels);
  if (!input.read_image(0, 0, 0, channels, type, values.data()))
    cannot_read(path, input.geterror());
  return values;
}

/// What a file's first channels mean.
struct ChannelPlan {
  int count;  // channels to read
  bool grey;  // the first is red, green and blue at once
  int alpha;  // index, or -1: opaque
};

ChannelPlan plan_channels(const ImageSpec& spec) {
  const bool grey = spec.nchannels < 3;
  const int colours = grey ? 1 : 3;
  const bool has_alpha = spec.nchannels > colours && spec.alpha_channel == colours;
  return {colours + has_alpha, grey, has_alpha ? colours : -1};
}

Image assemble(const ImageSpec& spec, const ChannelPlan& plan, const std::vector<float>& values) {
  Image image(spec.width, spec.height);
  const float* v = values.data();
  for (Rgba& pixel : image.pixels) {
    pixel = plan.grey ? Rgba(v[0], v[0], v[0], 1) : Rgba(v[0], v[1], v[2], 1);
    if (plan.alpha >= 0) pixel.a = v[plan.alpha];
    v += plan.count;
  }
  return image;
}

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw WorkError(fmt::format("{}: cannot write the picture: {}", path.string(), one_line(why)));
}

/// Encodes in memory, so that a full disk is met by our own write and nothing else.
std::string encode(const fs::path& path, ImageSpec spec, const TypeDesc& type, const void* pixels) {
  // Otherwise an EXR file holds the time of writing, and equal pictures give unequal files.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = ImageOutput::create(path.string(), &memory);
  if (!output) cannot_write(path, OIIO::geterror());
  if (!output->open(path.string(), spec) || !output->write_image(type, pixels) || !output->close())
    cannot_write(path, output->geterror());
  return {bytes.begin(), bytes.end()};
}

void write_pixels(const fs::path& path, const ImageSpec& spec, const TypeDesc& type,
                  const void* pixels) {
  write_text(path, encode(path, spec, type, pixels));
}

/// True for .exr, false for .png.
bool is_exr(const fs::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".exr" && ending != ".png")
    throw InputError(fmt::format("{}: ending '{}'; accepted: .exr, .png", path.string(), ending));
  return ending == ".exr";
}

/// Pictures of surfaces are smooth or empty: on them differences to the left neighbour at level 6
/// take a tenth of the time of level 9 with libpng's choice of filters, and as many bytes.
ImageSpec png_spec(int width, int height, int channels) {
  constexpr int filter_sub = 0x10;  // PNG_FILTER_SUB
  ImageSpec spec(width, height, channels, TypeDesc::UINT8);
  spec.attribute("png:filter", filter_sub);
  spec.attribute("png:compressionLevel", 6);
  return spec;
}

std::vector<std::uint8_t> to_bytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const Rgba& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) bytes.push_back(displayed_byte(pixel[c]));
  return bytes;
}

}  // namespace

Image read_image(const fs::path& path) {
  const SilentStderr silent;
  const auto input = open_input(path);
  const ImageSpec spec = input->spec();
  const ChannelPlan plan = plan_channels(spec);
  return assemble(spec, plan, read_channels<float>(*input, plan.count, TypeDesc::FLOAT, path));
}

CountImage read_counts(const fs::path& path) {
  const SilentStderr silent;
  const auto input = open_input(path);
  CountImage counts(input->spec().width, input->spec().height);
  counts.pixels = read_channels<std::uint32_t>(*input, 1, TypeDesc::UINT32, path);
  return counts;
}

void write_image(const fs::path& path, const Image& image) {
  if (is_exr(path)) {
    ImageSpec spec(image.width, image.height, 4, TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    return write_pixels(path, spec, TypeDesc::FLOAT, image.pixels.data());
  }
  write_pixels(path, png_spec(image.width, image.height, 3), TypeDesc::UINT8,
               to_bytes(image).data());
}

void write_counts(const fs::path& path, const CountImage& counts) {
  if (is_exr(path)) {
    ImageSpec spec(counts.width, counts.height, 1, TypeDesc::UINT32);
    spec.channelnames = {"layers"};
    spec.attribute("compression", "zip");
    return write_pixels(path, spec, TypeDesc::UINT32, counts.pixels.data());
  }
  std::vector<std::uint8_t> bytes(counts.pixels.size());
  std::transform(counts.pixels.begin(), counts.pixels.end(), bytes.begin(),
                 [](std::uint32_t n) { return std::uint8_t(std::min<std::uint32_t>(n, 255)); });
  write_pixels(path, png_spec(counts.width, counts.height, 1), TypeDesc::UINT8, bytes.data());
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
