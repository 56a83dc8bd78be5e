// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/support/block_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

namespace pellucid::fuzz {

Blocks blocks_of(Bytes bytes) {
  const int file = ::memfd_create("blocks", MFD_CLOEXEC);
  if (::write(file, bytes.data(), bytes.size()) != ssize_t(bytes.size()) ||
      ::lseek(file, 0, SEEK_SET) != 0)
    throw std::runtime_error("a file in memory takes no more");
  const struct Closed {
    ~Closed() { ::close(file); }
    int file;
  } closed{file};
  return Blocks(file, bytes.size());
}

}  // namespace pellucid::fuzz
