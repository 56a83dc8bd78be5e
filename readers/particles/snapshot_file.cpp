// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/particles/snapshot_file.h"

#include "core/files/child_reader.h"

namespace pellucid::readers {

Blocks read_snapshot_blocks(const std::filesystem::path& path) {
  return read_in_child("pellucid-read-hdf5", path);
}

}  // namespace pellucid::readers
