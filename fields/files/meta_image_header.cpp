// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/meta_image_header.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <initializer_list>
#include <map>
#include <sstream>
#include <vector>

#include "core/files/bad_file.h"
#include "fields/finite.h"

namespace pellucid::fields {
namespace {

using Keys = std::initializer_list<const char*>;

/// The lines "key = value" of a header, whose complaints name its file.
class Lines {
 public:
  Lines(std::istream& file, std::filesystem::path path) : path_(std::move(path)) {
    for (std::string line; std::getline(file, line);) {
      if (trimmed(line).empty()) continue;
      const std::size_t equals = line.find('=');
      if (equals == std::string::npos || line.size() > 4096)
        bad_file(path_, "its header has a line without 'key = value'");
      const std::string key = trimmed(line.substr(0, equals));
      values_[key] = trimmed(line.substr(equals + 1));
      if (key == "ElementDataFile") return;
    }
    bad_file(path_, "its header ends before ElementDataFile");
  }

  /// The value of the first of the keys that is there, and that key.
  std::pair<std::string, std::string> find(Keys keys, const std::string& otherwise) const {
    for (const char* key : keys)
      if (const auto found = values_.find(key); found != values_.end()) return *found;
    return {*keys.begin(), otherwise};
  }

  /// Which of the accepted values the key has.
  std::string one_of(const char* key, const std::string& otherwise, Keys accepted) const {
    std::string value = find({key}, otherwise).second;
    for (const char* candidate : accepted)
      if (value == candidate) return value;
    bad_file(path_, fmt::format("{} = {}; accepted: {}", key, value, fmt::join(accepted, ", ")));
  }

  bool is_true(Keys keys, bool otherwise) const {
    const auto [key, value] = find(keys, otherwise ? "True" : "False");
    const char first = value.empty() ? ' ' : value.front();
    if (first == 'T' || first == 't' || first == '1') return true;
    if (first == 'F' || first == 'f' || first == '0') return false;
    bad_file(path_, fmt::format("{} = {}; accepted: True, False", key, value));
  }

  template <std::size_t N>
  std::array<double, N> numbers(Keys keys, const std::string& otherwise) const {
    const auto [key, value] = find(keys, otherwise);
    std::istringstream text(value);
    std::array<double, N> numbers;
    for (double& number : numbers) text >> number;
    std::string rest;
    if (!text || text >> rest)
      bad_file(path_, fmt::format("{} = {}; expected {} numbers", key, value, N));
    return numbers;
  }

  Vec3 vec3(Keys keys, const std::string& otherwise) const {
    const auto v = numbers<3>(keys, otherwise);
    return {v[0], v[1], v[2]};
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  static std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
  }

  std::map<std::string, std::string, std::less<>> values_;
  std::filesystem::path path_;
};

/// As MetaIO names them: "long" is 4 bytes wide there.
constexpr std::pair<const char*, NumberType> number_types[] = {
    {"MET_CHAR", NumberType::i8},       {"MET_UCHAR", NumberType::u8},
    {"MET_SHORT", NumberType::i16},     {"MET_USHORT", NumberType::u16},
    {"MET_INT", NumberType::i32},       {"MET_UINT", NumberType::u32},
    {"MET_LONG", NumberType::i32},      {"MET_ULONG", NumberType::u32},
    {"MET_LONG_LONG", NumberType::i64}, {"MET_ULONG_LONG", NumberType::u64},
    {"MET_FLOAT", NumberType::f32},     {"MET_DOUBLE", NumberType::f64}};

NumberType type_of(const Lines& lines) {
  const std::string name = lines.find({"ElementType"}, "").second;
  std::string known;
  for (const auto& [candidate, type] : number_types) {
    if (name == candidate) return type;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", candidate);
  }
  bad_file(lines.path(), fmt::format("ElementType = {}; accepted: {}", name, known));
}

std::size_t channels_of(const Lines& lines) {
  constexpr double most = 16;
  const double count = lines.numbers<1>({"ElementNumberOfChannels"}, "1")[0];
  if (!(count >= 1 && count <= most) || count != std::floor(count))
    bad_file(lines.path(),
             fmt::format("ElementNumberOfChannels = {}; accepted: 1 to {}", count, most));
  return std::size_t(count);
}

std::array<std::size_t, 3> size_of(const Lines& lines) {
  const auto counts = lines.numbers<3>({"DimSize"}, "");
  std::array<std::size_t, 3> size{};
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(counts[a] >= 1 && counts[a] <= 1e6 && counts[a] == std::floor(counts[a])))
      bad_file(lines.path(),
               fmt::format("DimSize = {} {} {}; accepted: three whole numbers from 1 to 1000000",
                           counts[0], counts[1], counts[2]));
    size[a] = std::size_t(counts[a]);
  }
  return size;
}

std::optional<Mat3> directions_of(const Lines& lines) {
  const Keys keys = {"TransformMatrix", "Rotation", "Orientation"};
  const auto numbers = lines.numbers<9>(keys, "1 0 0 0 1 0 0 0 1");
  Mat3 axes;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t row = 0; row < 3; ++row)
      axes[glm::length_t(a)][glm::length_t(row)] = numbers[3 * a + row];
  if (!is_finite(axes) || !is_finite(glm::inverse(axes))) {
    const auto [key, value] = lines.find(keys, "");
    bad_file(lines.path(), fmt::format("{} = {}: its axes do not span space", key, value));
  }
  if (axes == Mat3(1)) return std::nullopt;
  return axes;
}

std::optional<std::size_t> skipped_of(const Lines& lines) {
  const double size = lines.numbers<1>({"HeaderSize"}, "0")[0];
  if (size == -1) return std::nullopt;
  if (!(size >= 0 && size < 1e15) || size != std::floor(size))
    bad_file(
        lines.path(),
        fmt::format("HeaderSize = {}; accepted: bytes, or -1 where the data are the file's last",
                    size));
  return std::size_t(size);
}

/// Lines behind the last one would have no meaning: that of the data's file ends the header.
void refuse_more_lines(std::istream& file, const std::filesystem::path& path) {
  std::string word;
  if (file >> word)
    bad_file(path, fmt::format("'{}' follows ElementDataFile, which has to be the last line",
                               word.substr(0, 40)));
}

}  // namespace

MetaImageHeader read_meta_image_header(std::istream& file, const std::filesystem::path& path) {
  const Lines lines(file, path);
  lines.one_of("NDims", "", {"3"});
  MetaImageHeader header;
  header.channels = channels_of(lines);
  header.type = type_of(lines);
  if (!lines.is_true({"BinaryData"}, true))
    bad_file(path, "BinaryData = False: numbers in text; accepted: True");
  header.compressed = lines.is_true({"CompressedData"}, false);
  header.big_endian = lines.is_true({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  header.size = size_of(lines);
  header.origin = lines.vec3({"Offset", "Position", "Origin"}, "0 0 0");
  header.spacing = lines.vec3({"ElementSpacing", "ElementSize"}, "1 1 1");
  header.directions = directions_of(lines);
  header.data_file = lines.find({"ElementDataFile"}, "").second;
  header.skipped = skipped_of(lines);
  if (!header.skipped && header.compressed)
    bad_file(path, "HeaderSize = -1 of compressed data, whose size is not known; accepted: bytes");
  if (header.data_file != "LOCAL") refuse_more_lines(file, path);
  return header;
}

}  // namespace pellucid::fields
