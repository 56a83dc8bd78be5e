// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/meta_image.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

std::size_t bytes_left(std::istream& file) {
  const auto here = file.tellg();
  file.seekg(0, std::ios::end);
  const auto left = std::max<std::streamoff>(0, file.tellg() - here);
  file.seekg(here);
  return std::size_t(left);
}

std::string read_rest(std::istream& file, const Path& path) {
  std::string bytes(bytes_left(file), '\0');
  file.read(bytes.data(), std::streamsize(bytes.size()));
  if (!file) bad_file(path, "cannot read its data");
  return bytes;
}

/// Up to 10^18 samples are counted exactly, but their bytes may be more than 2^64.
bool has_size(const MetaImageHeader& header, std::size_t bytes) {
  const std::size_t each = header.sample_bytes();
  return bytes / each == header.samples() && bytes % each == 0;
}

/// Of a stream of zlib or gzip as much as the header claims. No byte of it makes more than 1032: a
/// claim of more is refused before it is believed.
std::string inflated(std::string packed, const MetaImageHeader& header, const Path& path) {
  constexpr std::size_t most_of_a_byte = 1032;
  if (header.samples() / most_of_a_byte > packed.size() / header.sample_bytes())
    bad_file(path, fmt::format("{} compressed bytes hold no {} samples of {}", packed.size(),
                               header.samples(), header.sample_bytes()));
  std::string bytes(header.samples() * header.sample_bytes(), '\0');
  z_stream stream{};
  inflateInit2(&stream, MAX_WBITS + 32);  // 32: a head of zlib or of gzip
  std::size_t taken = 0, made = 0;
  int state = Z_OK;
  while (state == Z_OK) {
    constexpr std::size_t piece = std::size_t(1) << 30;  // its counters are 32 bits wide
    stream.next_in = reinterpret_cast<Bytef*>(packed.data()) + taken;
    stream.avail_in = uInt(std::min(piece, packed.size() - taken));
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data()) + made;
    stream.avail_out = uInt(std::min(piece, bytes.size() - made));
    const uInt in = stream.avail_in, out = stream.avail_out;
    state = inflate(&stream, Z_NO_FLUSH);
    taken += in - stream.avail_in;
    made += out - stream.avail_out;
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || made != bytes.size())
    bad_file(path, fmt::format("its compressed data are damaged, or not {} bytes", bytes.size()));
  return bytes;
}

/// Goes to where the data begin, as HeaderSize has it; behind a local header they begin after it.
void seek_data(std::istream& file, const Path& path, const MetaImageHeader& header) {
  file.clear();  // at its end, where nothing follows the header
  const auto here = std::size_t(file.tellg()), size = here + bytes_left(file);
  std::size_t first = header.skipped.value_or(0);
  if (!header.skipped) {
    if (header.samples() > size / header.sample_bytes())
      bad_file(path, fmt::format("{} bytes; its header says {} samples of {}", size,
                                 header.samples(), header.sample_bytes()));
    first = size - header.samples() * header.sample_bytes();
  }
  if (first == 0) return;
  if (first < here || first > size)
    bad_file(path, fmt::format("HeaderSize: data from byte {} of {}, behind a header of {}", first,
                               size, here));
  file.seekg(std::streamoff(first));
}

/// Exactly the claimed bytes; a claim that the file does not hold is refused before it is believed.
std::string read_bytes(std::istream& file, const Path& path, const MetaImageHeader& header) {
  if (header.compressed) return inflated(read_rest(file, path), header, path);
  if (const std::size_t bytes = bytes_left(file); !has_size(header, bytes))
    bad_file(path, fmt::format("{} bytes of data; its header says {} samples of {}", bytes,
                               header.samples(), header.sample_bytes()));
  return read_rest(file, path);
}

/// Opens the file of raw data that the header names.
std::ifstream open_beside(const Path& header, const std::string& name) {
  const Path path = header.parent_path() / name;
  try {
    require_file(path);
  } catch (const InputError& error) {
    bad_file(header, fmt::format("ElementDataFile = {}: {}", name, error.what()));
  }
  note_read(path);
  return std::ifstream(path, std::ios::binary);
}

void reverse_bytes(std::string& bytes, std::size_t each) {
  for (std::size_t i = 0; i < bytes.size(); i += each)
    std::reverse(bytes.begin() + std::ptrdiff_t(i), bytes.begin() + std::ptrdiff_t(i + each));
}

}  // namespace

MetaImage read_meta_image(const Path& path) {
  require_file(path);
  note_read(path);
  std::ifstream file(path, std::ios::binary);
  MetaImage image{read_meta_image_header(file, path), {}};
  const MetaImageHeader& header = image.header;
  std::ifstream beside;
  const bool is_local = header.data_file == "LOCAL";
  if (!is_local) beside = open_beside(path, header.data_file);
  std::istream& data = is_local ? file : beside;
  seek_data(data, path, header);
  image.bytes = read_bytes(data, path, header);
  if (header.big_endian) reverse_bytes(image.bytes, size_of(header.type));
  return image;
}

}  // namespace pellucid::fields
