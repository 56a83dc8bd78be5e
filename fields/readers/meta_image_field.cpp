// SPDX-License-Identifier: GPL-3.0-or-later
// Raw samples described by a MetaImage header, the text format of ITK and MetaIO: .mhd names a
// file of raw data, .mha holds them behind the header. Read here: NDims 3, DimSize, ElementType
// MET_FLOAT or MET_DOUBLE, ElementNumberOfChannels 3, ElementSpacing, Offset (Position, Origin),
// BinaryDataByteOrderMSB (ElementByteOrderMSB), ElementDataFile. Refused: compressed data, turned
// axes. It has one array, whose name is "velocity".

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "fields/readers/file_field.h"
#include "fields/readers/grid_source.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;
using Header = std::map<std::string, std::string, std::less<>>;

[[noreturn]] void fail(const Path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}", path.string(), why));
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// Up to and with ElementDataFile, behind which data may follow.
Header read_header(std::istream& file, const Path& path) {
  Header header;
  for (std::string line; std::getline(file, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || line.size() > 4096)
      fail(path, "its header has a line without 'key = value'");
    const std::string key = trimmed(line.substr(0, equals));
    header[key] = trimmed(line.substr(equals + 1));
    if (key == "ElementDataFile") return header;
  }
  fail(path, "its header ends before ElementDataFile");
}

/// The first of the keys that is there.
std::string value_of(const Header& header, std::initializer_list<const char*> keys,
                     const std::string& otherwise) {
  for (const char* key : keys)
    if (const auto found = header.find(key); found != header.end()) return found->second;
  return otherwise;
}

void require(const Header& header, const char* key, const std::string& otherwise,
             std::initializer_list<const char*> accepted, const Path& path) {
  const std::string value = value_of(header, {key}, otherwise);
  for (const char* candidate : accepted)
    if (value == candidate) return;
  fail(path, fmt::format("{} = {}; accepted: {}", key, value, fmt::join(accepted, ", ")));
}

Vec3 three_numbers(const Header& header, std::initializer_list<const char*> keys,
                   const std::string& otherwise, const Path& path) {
  std::istringstream text(value_of(header, keys, otherwise));
  Vec3 v;
  std::string rest;
  if (!(text >> v.x >> v.y >> v.z) || text >> rest)
    fail(path, fmt::format("{} = {}; expected three numbers", *keys.begin(), text.str()));
  return v;
}

struct Layout {
  std::array<std::size_t, 3> size;
  Vec3 origin, spacing;
  bool is_double, big_endian;

  std::size_t sample_bytes() const { return 3 * (is_double ? sizeof(double) : sizeof(float)); }
};

Layout parse(const Header& header, const Path& path) {
  require(header, "NDims", "", {"3"}, path);
  require(header, "ElementNumberOfChannels", "1", {"3"}, path);
  require(header, "ElementType", "", {"MET_FLOAT", "MET_DOUBLE"}, path);
  require(header, "BinaryData", "True", {"True"}, path);
  require(header, "CompressedData", "False", {"False"}, path);
  require(header, "TransformMatrix", "1 0 0 0 1 0 0 0 1", {"1 0 0 0 1 0 0 0 1"}, path);
  const Vec3 size = three_numbers(header, {"DimSize"}, "", path);
  const auto is_size = [](double n) { return n >= 1 && n <= 1e6 && n == std::floor(n); };
  if (!is_size(size.x) || !is_size(size.y) || !is_size(size.z))
    fail(path, fmt::format("DimSize = {} {} {}; accepted: three whole numbers from 1 to 1000000",
                           size.x, size.y, size.z));
  Layout layout;
  layout.size = {std::size_t(size.x), std::size_t(size.y), std::size_t(size.z)};
  layout.origin = three_numbers(header, {"Offset", "Position", "Origin"}, "0 0 0", path);
  layout.spacing = three_numbers(header, {"ElementSpacing", "ElementSize"}, "1 1 1", path);
  for (int a = 0; a < 3; ++a)
    if (layout.size[std::size_t(a)] > 1 &&
        !Axis::can_be_uniform(layout.origin[a], layout.spacing[a], layout.size[std::size_t(a)]))
      fail(path, fmt::format("ElementSpacing {} from {} along axis {}", layout.spacing[a],
                             layout.origin[a], a));
  layout.is_double = value_of(header, {"ElementType"}, "") == "MET_DOUBLE";
  layout.big_endian =
      value_of(header, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, "False") == "True";
  return layout;
}

/// Exactly the claimed bytes; a claim that the file does not hold is refused before it is believed.
/// Up to 10^18 samples are counted exactly, but their bytes may be more than 2^64.
std::string read_bytes(std::istream& file, const Path& path, const Layout& layout) {
  const auto begin = file.tellg();
  file.seekg(0, std::ios::end);
  const auto available = std::size_t(std::max<std::streamoff>(0, file.tellg() - begin));
  const std::size_t samples = layout.size[0] * layout.size[1] * layout.size[2];
  const std::size_t each = layout.sample_bytes();
  if (!file || available / each != samples || available % each != 0)
    fail(path, fmt::format("{} bytes of data; its header says {} samples of {}", available, samples,
                           each));
  file.seekg(begin);
  std::string bytes(available, '\0');
  file.read(bytes.data(), std::streamsize(available));
  if (!file) fail(path, "cannot read its data");
  return bytes;
}

/// Opens the file of raw data that the header names.
std::ifstream open_beside(const Path& header, const std::string& name) {
  const Path path = header.parent_path() / name;
  try {
    require_file(path);
  } catch (const InputError& error) {
    fail(header, fmt::format("ElementDataFile = {}: {}", name, error.what()));
  }
  note_read(path);
  return std::ifstream(path, std::ios::binary);
}

template <class Number>
std::unique_ptr<VectorField> make_field(const Layout& layout, std::string bytes,
                                        const FileOptions& options, const Path& path) {
  if (layout.big_endian)
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number))
      std::reverse(&bytes[i], &bytes[i] + sizeof(Number));
  const auto axis = [&](int a) {
    const std::size_t count = layout.size[std::size_t(a)];
    if (count == 1) return FileAxis{std::nullopt, layout.origin[a]};
    return FileAxis{Axis::uniform(layout.origin[a], layout.spacing[a], count)};
  };
  GridSource<glm::vec<3, Number>> source;
  source.axes = {axis(0), axis(1), axis(2)};
  source.samples.resize(bytes.size() / (3 * sizeof(Number)));
  std::memcpy(source.samples.data(), bytes.data(), bytes.size());
  source.interpolation = options.interpolation;
  source.periods = parse_periods(options.periodic, path.string());
  source.file = path.string();
  source.description = fmt::format("{}: {} × {} × {} samples", path.filename().string(),
                                   layout.size[0], layout.size[1], layout.size[2]);
  return make_grid_field(std::move(source));
}

std::unique_ptr<VectorField> read_meta_image_field(const Path& path, const FileOptions& options) {
  if (options.cells == CellValues::constant)
    fail(path, "cells=constant: its samples are at points; accepted: cells=averaged");
  if (!options.array.empty() && options.array != "velocity")
    fail(path, fmt::format("array={}: no such vectors; point arrays of three components: velocity",
                           options.array));
  std::ifstream file(path, std::ios::binary);
  const Header header = read_header(file, path);
  const Layout layout = parse(header, path);
  const std::string data = header.at("ElementDataFile");
  std::ifstream beside;
  if (data != "LOCAL") beside = open_beside(path, data);
  std::string bytes = read_bytes(data == "LOCAL" ? file : beside, path, layout);
  return layout.is_double ? make_field<double>(layout, std::move(bytes), options, path)
                          : make_field<float>(layout, std::move(bytes), options, path);
}

}  // namespace

std::vector<FileFormatRow> meta_image_formats() {
  return {{".mhd", "MetaImage header beside raw data", read_meta_image_field},
          {".mha", "MetaImage", read_meta_image_field}};
}

}  // namespace pellucid::fields
