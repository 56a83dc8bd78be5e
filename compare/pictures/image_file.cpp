// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr std::int64_t max_pixels = std::int64_t(1) << 28;  // nothing a header claims gets past it

[[noreturn]] void cannot_read(const fs::path& path, const std::string& why) {
  throw InputError(fmt::format("{}: cannot read the picture: {}", path.string(), why));
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

/// The picture's own window, in which its data may fill a part or reach beyond.
std::int64_t pixels_of(const ImageSpec& spec) {
  return std::int64_t(spec.full_width) * spec.full_height;
}

void check_size(const ImageSpec& spec, const fs::path& path) {
  const bool too_few = spec.width < 1 || spec.height < 1 || spec.full_width < 1 ||
                       spec.full_height < 1 || spec.nchannels < 1;
  const std::int64_t data = std::int64_t(spec.width) * spec.height;
  if (too_few || data > max_pixels || pixels_of(spec) > max_pixels)
    cannot_read(path, fmt::format("{}×{} pixels; accepted: 1 … {}", spec.full_width,
                                  spec.full_height, max_pixels));
  // The best compressors of pictures make them some thousand times smaller.
  constexpr double largest_compression = 8192;
  const double bytes = double(fs::file_size(path));
  if (double(data) * spec.nchannels > largest_compression * bytes)
    cannot_read(path, fmt::format("it claims {}×{} pixels in {:.0f} bytes", spec.width, spec.height,
                                  bytes));
}

/// A file that is open for reading. OpenImageIO would take "?key=value" in its name for arguments:
/// it gets the ending and what reads the file.
struct OpenPicture {
  explicit OpenPicture(const fs::path& path) : file(path.string(), OIIO::Filesystem::IOFile::Read) {
    ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);  // the colours as they are stored
    const std::string name = "picture" + path.extension().string();
    input = ImageInput::open(name, &wish, &file);
    const bool by_path = path.string().find('?') == std::string::npos;
    if (!input && by_path) input = ImageInput::open(path.string(), &wish);  // formats without proxy
    if (!input) cannot_read(path, OIIO::geterror());
  }

  OIIO::Filesystem::IOFile file;
  std::unique_ptr<ImageInput> input;
};

std::unique_ptr<OpenPicture> open_input(const fs::path& path) {
  require_file(path);
  note_read(path);
  auto picture = std::make_unique<OpenPicture>(path);
  if (picture->input->spec().deep) cannot_read(path, "it is deep; accepted: one sample per pixel");
  check_size(picture->input->spec(), path);
  return picture;
}

/// Channels first … first + count − 1, interleaved.
template <class T>
std::vector<T> read_channels(ImageInput& input, int first, int count, TypeDesc type,
                             const fs::path& path) {
  const ImageSpec spec = input.spec();
  std::vector<T> values(std::size_t(spec.width) * spec.height * count);
  if (!input.read_image(0, 0, first, first + count, type, values.data()))
    cannot_read(path, input.geterror());
  return values;
}

/// Which of a file's channels are what.
struct ChannelPlan {
  int color[3];  // red, green, blue
  int alpha;     // or -1: opaque
};

/// "R" and "beauty.R" are R.
std::string last_name(const std::string& channel) { return channel.substr(channel.rfind('.') + 1); }

/// The channel of one of these names; -1 where there is none.
int find_channel(const ImageSpec& spec, std::initializer_list<std::string_view> names) {
  for (int i = 0; i < spec.nchannels; ++i)
    if (std::ranges::find(names, last_name(spec.channel_name(i))) != names.end()) return i;
  return -1;
}

ChannelPlan plan_channels(const ImageSpec& spec, const fs::path& path) {
  const int red = find_channel(spec, {"R", "r", "red"}),
            green = find_channel(spec, {"G", "g", "green"}),
            blue = find_channel(spec, {"B", "b", "blue"}), grey = find_channel(spec, {"Y", "y"}),
            alpha = find_channel(spec, {"A", "a", "alpha"});
  if (red >= 0 && green >= 0 && blue >= 0) return {{red, green, blue}, alpha};
  const bool is_grey = grey >= 0 && spec.nchannels == 1 + (alpha >= 0);
  if (is_grey) return {{grey, grey, grey}, alpha};
  if (spec.nchannels == 1) return {{0, 0, 0}, -1};
  cannot_read(path, fmt::format("its channels are {}; accepted: R G B, Y, each with or without A, "
                                "or one of any name",
                                fmt::join(spec.channelnames, ", ")));
}

/// Pixels of the picture's window that the data leave out are 0, as OpenEXR has it.
template <class T, class Pixel>
Raster<T> place(const ImageSpec& spec, const Pixel& pixel_of) {
  Raster<T> picture(spec.full_width, spec.full_height, T(0));
  for (int y = 0; y < spec.height; ++y)
    for (int x = 0; x < spec.width; ++x) {
      const int column = spec.x + x - spec.full_x, row = spec.y + y - spec.full_y;
      if (column < 0 || column >= spec.full_width || row < 0 || row >= spec.full_height) continue;
      picture.pixels[std::size_t(row) * spec.full_width + column] =
          pixel_of(std::size_t(y) * spec.width + x);
    }
  return picture;
}

Image assemble(const ImageSpec& spec, const ChannelPlan& plan, const std::vector<float>& values) {
  return place<Rgba>(spec, [&](std::size_t i) {
    const float* v = &values[i * spec.nchannels];
    return Rgba(v[plan.color[0]], v[plan.color[1]], v[plan.color[2]],
                plan.alpha >= 0 ? v[plan.alpha] : 1);
  });
}

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw WorkError(fmt::format("{}: cannot write the picture: {}", path.string(), why));
}

/// Encodes in memory, so that a full disk is met by our own write and nothing else.
std::string encode(const fs::path& path, ImageSpec spec, const TypeDesc& type, const void* pixels) {
  // Otherwise an EXR file holds the time of writing, and equal pictures give unequal files.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  const std::string name = "picture" + path.extension().string();  // see OpenPicture
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = ImageOutput::create(name, &memory);
  if (!output) cannot_write(path, OIIO::geterror());
  if (!output->open(name, spec) || !output->write_image(type, pixels) || !output->close())
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
  const auto picture = open_input(path);
  const ImageSpec spec = picture->input->spec();
  const ChannelPlan plan = plan_channels(spec, path);
  return assemble(spec, plan,
                  read_channels<float>(*picture->input, 0, spec.nchannels, TypeDesc::FLOAT, path));
}

CountImage read_counts(const fs::path& path) {
  const SilentStderr silent;
  const auto picture = open_input(path);
  const auto counts = read_channels<std::uint32_t>(*picture->input, 0, 1, TypeDesc::UINT32, path);
  return place<std::uint32_t>(picture->input->spec(), [&](std::size_t i) { return counts[i]; });
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
