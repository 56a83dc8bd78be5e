// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/support/block_file.h"

#include <unistd.h>

#include <stdexcept>

#include "core/files/memory_file.h"

namespace pellucid::fuzz {

Blocks blocks_of(Bytes bytes) {
  const MemoryFile file;
  if (::write(file.descriptor(), bytes.data(), bytes.size()) != ssize_t(bytes.size()))
    throw std::runtime_error("a file in memory takes no more");
  return Blocks(file.descriptor());  // which stay mapped
}

}  // namespace pellucid::fuzz
