// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/grid_blocks.h"
#include "readers/vdb/parse_vdb.h"
#include "readers/vdb/vdb_open.h"

namespace pellucid::readers {

void parse_vdb_grids(const std::filesystem::path& path, const std::string& wanted,
                     BlockWriter& out) {
  const auto file = open_vdb(path);
  int number = 0;
  for (auto name = file->beginName(); name != file->endName(); ++name) {
    const bool with_tree = wanted.empty() || *name == wanted;
    const openvdb::GridBase::Ptr grid =
        with_tree ? file->readGrid(*name) : file->readGridMetadata(*name);
    write_grid(number++, *grid, with_tree, out);
  }
}

}  // namespace pellucid::readers
