// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of a MetaImage. It has one array, whose name is "velocity".

#include <fmt/format.h>

#include "core/files/bad_file.h"
#include "fields/files/meta_image.h"
#include "fields/finite.h"
#include "fields/readers/file_field.h"
#include "fields/readers/grid_source.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

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

/// The vectors of an image, whose numbers are of T.
template <class Number, class T>
std::vector<glm::vec<3, Number>> vectors_in(const MetaImage& image) {
  const std::span<const T> numbers = image.numbers<T>();
  std::vector<glm::vec<3, Number>> vectors(numbers.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = {Number(numbers[3 * i]), Number(numbers[3 * i + 1]), Number(numbers[3 * i + 2])};
  return vectors;
}

template <class Number>
std::unique_ptr<VectorField> make_field(const MetaImageHeader& header,
                                        std::vector<glm::vec<3, Number>> samples,
                                        const FileOptions& options, const Path& path) {
  GridSource<glm::vec<3, Number>> source;
  source.axes = {axis_of(header, 0, path), axis_of(header, 1, path), axis_of(header, 2, path)};
  source.frame = frame_of(header, path);
  source.samples = std::move(samples);
  source.interpolation = options.interpolation;
  source.periods = periods_of(options, path.string());
  source.file = path.string();
  source.description = fmt::format("{}: {} × {} × {} samples", path.filename().string(),
                                   header.size[0], header.size[1], header.size[2]);
  return make_grid_field(std::move(source));
}

/// In floats where these hold every number of the file's type.
std::unique_ptr<VectorField> make_field(const MetaImage& image, const FileOptions& options,
                                        const Path& path) {
  const auto field = [&](auto samples) {
    return make_field(image.header, std::move(samples), options, path);
  };
  switch (image.header.type) {
    case NumberType::i8:
      return field(vectors_in<float, std::int8_t>(image));
    case NumberType::u8:
      return field(vectors_in<float, std::uint8_t>(image));
    case NumberType::i16:
      return field(vectors_in<float, std::int16_t>(image));
    case NumberType::u16:
      return field(vectors_in<float, std::uint16_t>(image));
    case NumberType::f32:
      return field(vectors_in<float, float>(image));
    case NumberType::i32:
      return field(vectors_in<double, std::int32_t>(image));
    case NumberType::u32:
      return field(vectors_in<double, std::uint32_t>(image));
    case NumberType::i64:
      return field(vectors_in<double, std::int64_t>(image));
    case NumberType::u64:
      return field(vectors_in<double, std::uint64_t>(image));
    case NumberType::f64:
      return field(vectors_in<double, double>(image));
  }
  return nullptr;  // not reached
}

std::unique_ptr<VectorField> read_meta_image_field(const Path& path, const FileOptions& options) {
  if (options.cells == CellValues::constant)
    bad_file(path, "cells=constant: its samples are at points; accepted: cells=averaged");
  if (options.quantity == Quantity::scalar)
    bad_file(path, fmt::format("no scalar '{}': it has a velocity alone", options.array));
  const MetaImage image = read_meta_image(path);
  if (image.header.channels != 3)
    bad_file(path, fmt::format("ElementNumberOfChannels = {}; accepted of a field: 3",
                               image.header.channels));
  if (!options.array.empty() && options.array != "velocity")
    bad_file(path,
             fmt::format("array={}: no such vectors; point arrays of three components: velocity",
                         options.array));
  return make_field(image, options, path);
}

}  // namespace

std::vector<FileFormatRow> meta_image_formats() {
  return {
      {".mhd", "MetaImage header beside raw data", read_meta_image_field,
       "vectors of three numbers of any type, an isosurface's of one; compressed or not; its axes "
       "may be turned; HeaderSize is honoured"},
      {".mha", "MetaImage", read_meta_image_field, "as .mhd"}};
}

}  // namespace pellucid::fields
