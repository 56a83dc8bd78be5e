// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/support/block_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

namespace pellucid::fuzz {
namespace {

/// A file in memory, without a name.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("blocks", MFD_CLOEXEC)) {}
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return file_; }

 private:
  int file_;
};

}  // namespace

Blocks blocks_of(Bytes bytes) {
  const MemoryFile file;
  if (::write(file.descriptor(), bytes.data(), bytes.size()) != ssize_t(bytes.size()))
    throw std::runtime_error("a file in memory takes no more");
  return Blocks(file.descriptor());  // which stay mapped
}

}  // namespace pellucid::fuzz
