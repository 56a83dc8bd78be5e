// SPDX-License-Identifier: GPL-3.0-or-later
// Raw samples described by a MetaImage header, the text format of ITK and MetaIO: .mhd names a
// file of raw data, .mha holds them behind the header; both may be compressed (zlib). It has one
// array, whose name is "velocity".

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "fields/files/meta_image_header.h"
#include "fields/finite.h"
#include "fields/readers/file_field.h"
#include "fields/readers/grid_source.h"

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

/// Along the world's axes; of turned ones in units of samples.
FileAxis axis_of(const MetaImageHeader& header, int a, const Path& path) {
  const std::size_t count = header.size[std::size_t(a)];
  const double first = header.directions ? 0 : header.origin[a];
  const double step = header.directions ? 1 : header.spacing[a];
  if (count == 1) return {std::nullopt, first};
  if (!Axis::can_be_uniform(first, step, count))
    bad_file(path, fmt::format("ElementSpacing {} from {} along axis {}", step, first, a));
  return {Axis::uniform(first, step, count)};
}

std::optional<GridFrame> frame_of(const MetaImageHeader& header, const Path& path) {
  if (!header.directions) return std::nullopt;
  Mat3 world_from_grid = *header.directions;
  for (int a = 0; a < 3; ++a) world_from_grid[a] *= header.spacing[a];
  const GridFrame frame{glm::inverse(world_from_grid), header.origin};
  if (!is_finite(frame.grid_from_world) || !is_finite(frame.origin))
    bad_file(path, "its directions and spacings do not span space");
  return frame;
}

template <class Number>
std::unique_ptr<VectorField> make_field(const MetaImageHeader& header, std::string bytes,
                                        const FileOptions& options, const Path& path) {
  if (header.big_endian)
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number))
      std::reverse(&bytes[i], &bytes[i] + sizeof(Number));
  GridSource<glm::vec<3, Number>> source;
  source.axes = {axis_of(header, 0, path), axis_of(header, 1, path), axis_of(header, 2, path)};
  source.frame = frame_of(header, path);
  source.samples.resize(bytes.size() / (3 * sizeof(Number)));
  std::memcpy(source.samples.data(), bytes.data(), bytes.size());
  source.interpolation = options.interpolation;
  source.periods = parse_periods(options.periodic, path.string());
  source.file = path.string();
  source.description = fmt::format("{}: {} × {} × {} samples", path.filename().string(),
                                   header.size[0], header.size[1], header.size[2]);
  return make_grid_field(std::move(source));
}

std::unique_ptr<VectorField> read_meta_image_field(const Path& path, const FileOptions& options) {
  if (options.cells == CellValues::constant)
    bad_file(path, "cells=constant: its samples are at points; accepted: cells=averaged");
  if (options.quantity == Quantity::scalar)
    bad_file(path, fmt::format("no scalar '{}': it has a velocity alone", options.array));
  if (!options.array.empty() && options.array != "velocity")
    bad_file(path,
             fmt::format("array={}: no such vectors; point arrays of three components: velocity",
                         options.array));
  std::ifstream file(path, std::ios::binary);
  const MetaImageHeader header = read_meta_image_header(file, path);
  std::ifstream beside;
  const bool is_local = header.data_file == "LOCAL";
  if (!is_local) beside = open_beside(path, header.data_file);
  std::istream& data = is_local ? file : beside;
  seek_data(data, path, header);
  std::string bytes = read_bytes(data, path, header);
  return header.is_double ? make_field<double>(header, std::move(bytes), options, path)
                          : make_field<float>(header, std::move(bytes), options, path);
}

}  // namespace

std::vector<FileFormatRow> meta_image_formats() {
  return {{".mhd", "MetaImage header beside raw data", read_meta_image_field,
           "vectors of three floats or doubles, compressed or not; its axes may be turned; "
           "HeaderSize is honoured"},
          {".mha", "MetaImage", read_meta_image_field, "as .mhd"}};
}

}  // namespace pellucid::fields
