// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/vdb_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files/child_reader.h"

namespace pellucid::readers {

std::vector<VdbGrid> read_vdb_grids(const std::filesystem::path& path, const std::string& wanted) {
  const Blocks blocks = read_in_child("pellucid-read-vdb", path, {"grids", wanted});
  try {
    return grids_of(blocks);
  } catch (const BlockError& error) {
    throw InputError(fmt::format("{}: not a valid .vdb file: {}", path.string(), error.what()));
  }
}

Blocks read_vdb_point_blocks(const std::filesystem::path& path) {
  return read_in_child("pellucid-read-vdb", path, {"points"});
}

}  // namespace pellucid::readers
