// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/ply/ply_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/options/parameters.h"

namespace pellucid::geometry::ply {
namespace {

std::optional<Type> parse_type(std::string_view name) {
  struct Row {
    std::string_view old_name, new_name;
    Type type;
  };
  static constexpr std::array<Row, 8> rows{{{"char", "int8", Type::int8},
                                            {"uchar", "uint8", Type::uint8},
                                            {"short", "int16", Type::int16},
                                            {"ushort", "uint16", Type::uint16},
                                            {"int", "int32", Type::int32},
                                            {"uint", "uint32", Type::uint32},
                                            {"float", "float32", Type::float32},
                                            {"double", "float64", Type::float64}}};
  for (const Row& row : rows)
    if (name == row.old_name || name == row.new_name) return row.type;
  return std::nullopt;
}

std::optional<Encoding> parse_encoding(std::string_view name) {
  if (name == "ascii") return Encoding::ascii;
  if (name == "binary_little_endian") return Encoding::little_endian;
  if (name == "binary_big_endian") return Encoding::big_endian;
  return std::nullopt;
}

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<Property> parse_property(const std::vector<std::string>& words) {
  Property property;
  if (words.size() == 3) {
    const auto type = parse_type(words[1]);
    if (!type) return std::nullopt;
    return Property{words[2], *type};
  }
  if (words.size() != 5 || words[1] != "list") return std::nullopt;
  const auto count_type = parse_type(words[2]), type = parse_type(words[3]);
  if (!count_type || !type) return std::nullopt;
  return Property{words[4], *type, true, *count_type};
}

template <class T>
double decode(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
      return 4;
    case Type::float64:
      return 8;
  }
  return 0;
}

Reader::Reader(std::string file, std::string_view content)
    : file_(std::move(file)), content_(content) {}

std::string Reader::where() const {
  if (encoding_ == Encoding::ascii) return fmt::format("{}:{}", file_, line_);
  return fmt::format("{}: byte {}", file_, position_);
}

void Reader::fail(const std::string& what) const { throw InputError(where() + ": " + what); }

std::string_view Reader::next_line() {
  ++line_;
  if (position_ >= content_.size()) fail("the file ends inside the header; expected end_header");
  const std::size_t end = std::min(content_.find('\n', position_), content_.size());
  std::string_view line = content_.substr(position_, end - position_);
  position_ = std::min(end + 1, content_.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Header Reader::read_header() {
  if (next_line() != "ply") fail("not a PLY file; expected 'ply' on the first line");
  Header header;
  for (bool has_format = false;;) {
    const auto words = words_of(next_line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header" && !has_format) fail("expected a format line before end_header");
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() == 3 && parse_encoding(words[1])) {
      header.encoding = *parse_encoding(words[1]);
      has_format = true;
    } else if (double count = 0; words[0] == "element" && words.size() == 3 &&
                                 parse_number(words[2], count) && count >= 0 && count < 0x1p53) {
      header.elements.push_back({words[1], static_cast<std::uint64_t>(count), {}});
    } else if (const auto property = parse_property(words);
               words[0] == "property" && property && !header.elements.empty()) {
      header.elements.back().properties.push_back(*property);
    } else {
      fail(
          fmt::format("'{}': accepted: format, element NAME COUNT, property TYPE NAME, property "
                      "list TYPE TYPE NAME, comment, end_header",
                      fmt::join(words, " ")));
    }
  }
  check_elements(header.elements);
  encoding_ = header.encoding;
  ++line_;
  return header;
}

/// Names have to tell elements and properties apart, and what has no property takes no byte, so
/// that no count of it can be held to the file's size.
void Reader::check_elements(const std::vector<Element>& elements) const {
  std::set<std::string_view> names;
  for (const Element& element : elements) {
    if (!names.insert(element.name).second) fail(fmt::format("two elements '{}'", element.name));
    if (element.properties.empty() && element.count > 0)
      fail(fmt::format("{} × '{}' without a property", element.count, element.name));
    std::set<std::string_view> properties;
    for (const Property& property : element.properties)
      if (!properties.insert(property.name).second)
        fail(fmt::format("element '{}' has two properties '{}'", element.name, property.name));
  }
}

std::string_view Reader::next_word() {
  for (; position_ < content_.size() && is_space(content_[position_]); ++position_)
    if (content_[position_] == '\n') ++line_;
  const std::size_t begin = position_;
  while (position_ < content_.size() && !is_space(content_[position_])) ++position_;
  return content_.substr(begin, position_ - begin);
}

double Reader::next(Type type) {
  if (encoding_ != Encoding::ascii) return next_binary(type);
  const std::string_view word = next_word();
  if (word.empty()) fail("the file ends before all the elements that its header declares");
  double value = 0;
  if (!parse_number(word, value)) fail(fmt::format("'{}': expected a number", word));
  return value;
}

double Reader::next_binary(Type type) {
  if (bytes_left() < size_of(type))
    fail("the file ends before all the elements that its header declares");
  const char* bytes = content_.data() + position_;
  position_ += size_of(type);
  const bool swap =
      (encoding_ == Encoding::big_endian) == (std::endian::native == std::endian::little);
  switch (type) {
    case Type::int8:
      return decode<std::int8_t>(bytes, swap);
    case Type::uint8:
      return decode<std::uint8_t>(bytes, swap);
    case Type::int16:
      return decode<std::int16_t>(bytes, swap);
    case Type::uint16:
      return decode<std::uint16_t>(bytes, swap);
    case Type::int32:
      return decode<std::int32_t>(bytes, swap);
    case Type::uint32:
      return decode<std::uint32_t>(bytes, swap);
    case Type::float32:
      return decode<float>(bytes, swap);
    case Type::float64:
      return decode<double>(bytes, swap);
  }
  return 0;
}

}  // namespace pellucid::geometry::ply
