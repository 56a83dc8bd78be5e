// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "core/files/blocks.h"

namespace pellucid::testing {

/// A file in memory, which lives as long as this does.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("blocks", 0)) {}
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return file_; }

  std::string content() const {
    std::string bytes(std::size_t(::lseek(file_, 0, SEEK_END)), '\0');
    EXPECT_EQ(::pread(file_, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
    return bytes;
  }
  /// Returns the blocks in it, none of which may claim more than there is.
  Blocks blocks() const {
    const off_t size = ::lseek(file_, 0, SEEK_END);
    EXPECT_EQ(::lseek(file_, 0, SEEK_SET), 0);
    return Blocks(file_, std::uint64_t(size));
  }
  void set(const std::string& bytes) const {
    EXPECT_EQ(::ftruncate(file_, 0), 0);
    EXPECT_EQ(::pwrite(file_, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
  }

 private:
  int file_;
};

/// Returns what write(BlockWriter&) writes, read back.
template <class Write>
Blocks blocks_of(const Write& write) {
  const MemoryFile file;
  BlockWriter out(file.descriptor());
  write(out);
  out.finish();
  return file.blocks();
}

}  // namespace pellucid::testing
