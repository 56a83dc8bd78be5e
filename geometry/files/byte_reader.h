// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::geometry {

/// A ByteReader reads numbers of a binary file one after another, or at a place. It throws
/// InputError that names the file and the byte for what lies beyond its end, and allocates for no
/// more than the file holds.
class ByteReader {
 public:
  /// Reads the whole file. Numbers are little-endian unless it is told otherwise.
  explicit ByteReader(const std::filesystem::path& path)
      : file_(path.string()), content_(read_text(path)) {}

  /// Sets whether numbers are big-endian.
  void set_big_endian(bool big) { swap_ = big == (std::endian::native == std::endian::little); }
  /// Goes to a byte of the file, from 0.
  void seek(std::uint64_t position) {
    if (position > content_.size()) fail(fmt::format("byte {} is beyond its end", position));
    position_ = position;
  }
  std::uint64_t position() const { return position_; }
  std::uint64_t bytes_left() const { return content_.size() - position_; }
  std::string_view content() const { return content_; }

  /// Returns the next number; `what` names it in a message.
  template <class T>
  T number(std::string_view what = "a number") {
    return decode<T>(take(sizeof(T), what).data());
  }
  /// Returns the next `count` numbers.
  template <class T>
  std::vector<T> numbers(std::uint64_t count, std::string_view what) {
    if (count > bytes_left() / sizeof(T)) refuse(count, sizeof(T), what);
    const char* bytes = take(count * sizeof(T), what).data();
    std::vector<T> values(count);
    for (std::uint64_t i = 0; i < count; ++i) values[i] = decode<T>(bytes + i * sizeof(T));
    return values;
  }
  /// Returns the next `count` bytes.
  std::string_view take(std::uint64_t count, std::string_view what) {
    if (count > bytes_left()) refuse(count, 1, what);
    const std::string_view bytes = std::string_view(content_).substr(position_, count);
    position_ += count;
    return bytes;
  }

  /// Throws InputError "FILE: byte N: `what`".
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: byte {}: {}", file_, position_, what));
  }

 private:
  [[noreturn]] void refuse(std::uint64_t count, std::size_t each, std::string_view what) const {
    fail(fmt::format("{} of {} × {} bytes, but {} are left: truncated?", what, count, each,
                     bytes_left()));
  }

  template <class T>
  T decode(const char* bytes) const {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }

  std::string file_, content_;
  std::uint64_t position_ = 0;
  bool swap_ = std::endian::native != std::endian::little;
};

}  // namespace pellucid::geometry
