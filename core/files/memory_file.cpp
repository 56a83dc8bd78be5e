// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/memory_file.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace pellucid {

MemoryFile::MemoryFile() : file_(::memfd_create("pellucid", MFD_CLOEXEC)) {
  if (file_ < 0) throw WorkError(fmt::format("no memory for a file: {}", std::strerror(errno)));
}

MemoryFile::~MemoryFile() { ::close(file_); }

}  // namespace pellucid
