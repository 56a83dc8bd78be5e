// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The PLY format (Greg Turk, 1994): a text header that declares elements and their properties, then
// the values in text or in binary of either byte order. Debian packages no reader that keeps
// arbitrary vertex attributes and non-manifold triangles, hence this one.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pellucid::geometry::ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { ascii, little_endian, big_endian };

struct Property {
  std::string name;
  Type type = Type::float32;
  bool is_list = false;
  Type count_type = Type::uint8;  // lists only
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

std::size_t size_of(Type type);

/// Reads the values that follow the header one by one, and knows where it stands.
class Reader {
 public:
  /// `file` names the text in messages; `content` is the whole file and has to outlive the reader.
  Reader(std::string file, std::string_view content);

  /// Throws InputError with the line for anything that is not a PLY header.
  Header read_header();

  /// The next value, as double: exact for every PLY type. Throws InputError at the file's end and,
  /// in text, for a word that is not a number.
  double next(Type type);

  std::size_t bytes_left() const { return content_.size() - position_; }
  /// "sheet.ply:812" in text, "sheet.ply: byte 90112" in binary.
  std::string where() const;

 private:
  std::string_view next_line();
  std::string_view next_word();
  double next_binary(Type type);
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_;
  std::string_view content_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  Encoding encoding_ = Encoding::ascii;
};

}  // namespace pellucid::geometry::ply
