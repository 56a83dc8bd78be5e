// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace pellucid::compare {

class ArchiveWriter;

/// An ArrayFile gathers the numbers of an array whose length is not known yet, on disk, in a file
/// without a name; then it is an .npy file, which is the header and the numbers (NumPy's format
/// 1.0).
class ArrayFile {
 public:
  /// Makes the file on the disk that `beside` lies on. `type` is NumPy's name of the numbers' type,
  /// "<f8"; the array has `columns` of them a row, or one dimension where that is 0. Throws
  /// WorkError, as add() does, when the disk is full.
  ArrayFile(std::string name, std::string type, std::size_t columns,
            const std::filesystem::path& beside);

  template <class T>
  void add(std::span<const T> numbers) {
    write({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()}, sizeof(T));
  }
  /// Appends it to an archive as NAME.npy.
  void pack(ArchiveWriter& archive);

 private:
  void write(std::span<const char> bytes, std::size_t size_of_number);
  [[noreturn]] void fail() const;

  std::string name_, type_;
  std::size_t columns_;
  std::filesystem::path beside_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t count_ = 0, bytes_ = 0;
};

/// Returns the header of an .npy file: `shape` is as Python writes a tuple's elements, "3, 4" or
/// "3,".
std::string npy_header(std::string_view type, std::string_view shape);

}  // namespace pellucid::compare
