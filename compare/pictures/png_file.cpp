// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/png_file.h"

#include <fmt/format.h>
#include <png.h>

#include <vector>

#include "core/error.h"

namespace pellucid::compare {
namespace {

struct PngPicture {
  int width, height, channels;
  const std::uint8_t* bytes;
  std::span<const png_text> texts;
};

/// libpng takes them by pointers that are not constant.
std::vector<png_text> texts_of(const PictureText& text) {
  std::vector<png_text> texts;
  for (const auto& [name, words] : text) {
    png_text& one = texts.emplace_back();
    one.compression = PNG_ITXT_COMPRESSION_NONE;
    one.key = const_cast<char*>(name.c_str());
    one.text = const_cast<char*>(words.c_str());
    one.itxt_length = words.size();
  }
  return texts;
}

int color_type(int channels) {
  if (channels == 1) return PNG_COLOR_TYPE_GRAY;
  return channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
}

/// libpng leaves by longjmp(): nothing that it jumps out of may have anything to destroy.
void keep(png_structp png, png_bytep bytes, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), size);
}

/// libpng prints what it has to say, if nobody else takes it; only app/ prints.
[[noreturn]] void leave(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignore(png_structp, png_const_charp) {}

/// Pictures of surfaces are smooth or empty: on them differences to the left neighbour at level 6
/// take a tenth of the time of level 9 with libpng's choice of filters, and as many bytes. Returns
/// false when libpng fails.
bool write_picture(png_structp png, png_infop info, const PngPicture& picture) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_compression_level(png, 6);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(png, info, png_uint_32(picture.width), png_uint_32(picture.height), 8,
               color_type(picture.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!picture.texts.empty())
    png_set_text(png, info, picture.texts.data(), int(picture.texts.size()));
  png_write_info(png, info);
  const std::size_t row = std::size_t(picture.width) * std::size_t(picture.channels);
  for (std::size_t y = 0; y < std::size_t(picture.height); ++y)
    png_write_row(png, picture.bytes + y * row);
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string encode_png(const std::filesystem::path& path, int width, int height, int channels,
                       std::span<const std::uint8_t> bytes, const PictureText& text) {
  std::string file;
  const std::vector<png_text> texts = texts_of(text);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, &leave, &ignore);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &file, &keep, nullptr);
  const bool done = write_picture(png, info, {width, height, channels, bytes.data(), texts});
  png_destroy_write_struct(&png, &info);
  if (!done) throw WorkError(fmt::format("{}: cannot write the picture", path.string()));
  return file;
}

}  // namespace pellucid::compare
