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

/// A Type is the type of a value in a PLY file; the number is its size in bits.
enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
/// An Encoding says how values are written: as text, or in binary of a byte order.
enum class Encoding { ascii, little_endian, big_endian };

/// A Property declares one value of each element, or a list of values behind their count.
struct Property {
  std::string name;
  Type type = Type::float32;
  bool is_list = false;
  Type count_type = Type::uint8;  // lists only
};

/// An Element declares `count` records of the same properties, such as all vertices.
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

/// A Header declares the elements of a PLY file, in the order in which their values follow.
struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

/// Returns the size of a value in bytes, in binary.
std::size_t size_of(Type type);

/// A Reader reads the header of a PLY file and then its values one by one, and knows where it
/// stands.
class Reader {
 public:
  /// Starts at the front of `content`, which is the whole file and has to outlive the reader;
  /// `file` names it in messages.
  Reader(std::string file, std::string_view content);

  /// Reads the header. Throws InputError with the line for anything that is not a PLY header.
  Header read_header();

  /// Reads the next value, as double: exact for every PLY type. Throws InputError at the file's end
  /// and, in text, for a word that is not a number.
  double next(Type type);

  std::size_t bytes_left() const { return content_.size() - position_; }
  /// Returns where it stands: "sheet.ply:812" in text, "sheet.ply: byte 90112" in binary.
  std::string where() const;

 private:
  std::string_view next_line();
  std::string_view next_word();
  double next_binary(Type type);
  void check_elements(const std::vector<Element>& elements) const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string file_;
  std::string_view content_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  Encoding encoding_ = Encoding::ascii;
};

}  // namespace pellucid::geometry::ply
