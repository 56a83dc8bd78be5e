// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/deep/array_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

#include "compare/pack/archive_writer.h"
#include "core/files/write_failure.h"

namespace pellucid::compare {
namespace {

/// A file that is gone when it is closed.
std::FILE* open_nameless(const std::filesystem::path& beside) {
  std::string name = beside.string() + ".XXXXXX";
  const int file = ::mkstemp(name.data());
  if (file < 0) fail_writing(beside, errno);
  ::unlink(name.c_str());
  return ::fdopen(file, "w+b");
}

}  // namespace

std::string npy_header(std::string_view type, std::string_view shape) {
  constexpr std::size_t alignment = 64, before = 10;  // the mark, the version, and the length
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, shape);
  while ((before + text.size() + 1) % alignment != 0) text += ' ';
  text += '\n';
  const char low = char(text.size() % 256), high = char(text.size() / 256);
  return std::string("\x93NUMPY\x01") + '\0' + low + high + text;
}

ArrayFile::ArrayFile(std::string name, std::string type, std::size_t columns,
                     const std::filesystem::path& beside)
    : name_(std::move(name)),
      type_(std::move(type)),
      columns_(columns),
      beside_(beside),
      file_(open_nameless(beside), &std::fclose) {}

void ArrayFile::fail() const { fail_writing(beside_, errno); }

void ArrayFile::write(std::span<const char> bytes, std::size_t size_of_number) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
  count_ += bytes.size() / size_of_number;
  bytes_ += bytes.size();
}

void ArrayFile::pack(ArchiveWriter& archive) {
  const std::string header =
      npy_header(type_, columns_ == 0 ? fmt::format("{},", count_)
                                      : fmt::format("{}, {}", count_ / columns_, columns_));
  if (std::fflush(file_.get()) != 0) fail();
  std::rewind(file_.get());
  archive.begin(name_ + ".npy", header.size() + bytes_);
  archive.write(header);
  std::array<char, 1 << 16> block;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file_.get()))
    archive.write(std::span(block).first(got));
  if (std::ferror(file_.get())) fail();
}

}  // namespace pellucid::compare
