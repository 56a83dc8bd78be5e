// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "readers/pictures/parse_picture.h"

namespace pellucid::readers {
namespace {

/// libpng leaves by longjmp(): no function that it jumps out of may have anything to destroy.
class PngReader {
 public:
  explicit PngReader(const std::filesystem::path& path)
      : path_(path),
        file_(std::fopen(path.c_str(), "rb"), &std::fclose),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail,
                                    &PngReader::warn)),
        info_(png_create_info_struct(png_)) {
    if (!file_) cannot_read_picture(path, std::strerror(errno));
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Calls step(png, info). Throws InputError with libpng's words when it jumps out.
  template <class Step>
  void step(const Step& step) {
    if (setjmp(png_jmpbuf(png_))) cannot_read_picture(path_, words_);
    step(png_, info_);
  }

  std::FILE* file() const { return file_.get(); }

 private:
  [[noreturn]] static void fail(png_structp png, png_const_charp words) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::snprintf(reader->words_, sizeof reader->words_, "%s", words);
    png_longjmp(png, 1);
  }
  static void warn(png_structp, png_const_charp) {}  // of chunks beside the pixels

  const std::filesystem::path& path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  char words_[200] = {};
  png_structp png_;
  png_infop info_;
};

struct PngHead {
  PictureWindow window;
  int channels = 0;
  int bits = 0;  // of a value: 8 or 16
};

/// Reads the head, and asks for grey or colours in whole bytes, with alpha where there is any.
PngHead read_head(PngReader& reader) {
  PngHead head;
  reader.step([&](png_structp png, png_infop info) {
    png_init_io(png, reader.file());
    png_read_info(png, info);
    png_set_expand(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    head.window.width = std::int32_t(png_get_image_width(png, info));
    head.window.height = std::int32_t(png_get_image_height(png, info));
    head.channels = png_get_channels(png, info);
    head.bits = png_get_bit_depth(png, info);
  });
  return head;
}

std::vector<png_byte> read_bytes(PngReader& reader, const PngHead& head) {
  const std::size_t row = std::size_t(head.window.width) * head.channels * (head.bits / 8);
  std::vector<png_byte> bytes(row * head.window.height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < std::size_t(head.window.height); ++y)
    rows.push_back(bytes.data() + y * row);
  reader.step([&](png_structp png, png_infop) {
    png_read_image(png, rows.data());
    png_read_end(png, nullptr);  // what follows the pixels is whole too
  });
  return bytes;
}

/// Channel `number`: n/255, or n/65535 of the two bytes of which PNG has the larger first.
std::vector<float> channel_of(const std::vector<png_byte>& bytes, const PngHead& head, int number) {
  std::vector<float> values(std::size_t(head.window.pixels()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = i * std::size_t(head.channels) + std::size_t(number);
    values[i] = head.bits == 8 ? float(bytes[at]) / 255.f
                               : float(bytes[2 * at] << 8 | bytes[2 * at + 1]) / 65535.f;
  }
  return values;
}

std::vector<std::string> names_of(int channels) {
  std::vector<std::string> names =
      channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
  if (channels % 2 == 0) names.emplace_back("A");
  return names;
}

}  // namespace

void parse_png(const std::filesystem::path& path, BlockWriter& out) {
  PngReader reader(path);
  const PngHead head = read_head(reader);
  check_picture_size(path, head.window, head.window, std::size_t(head.channels));
  const std::vector<png_byte> bytes = read_bytes(reader, head);
  const std::vector<std::string> names = names_of(head.channels);
  write_windows(head.window, head.window, out);
  for (int i = 0; i < head.channels; ++i)
    write_channel(names[std::size_t(i)], channel_of(bytes, head, i), out);
}

}  // namespace pellucid::readers
