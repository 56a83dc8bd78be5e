// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/archives/archive_file.h"

#include "core/files/child_reader.h"

namespace pellucid::readers {

Blocks read_archive(const std::filesystem::path& path) {
  return read_in_child("pellucid-read-archive", path, {});
}

}  // namespace pellucid::readers
