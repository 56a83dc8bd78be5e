// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/grid_blocks.h"
#include "readers/vdb/parse_vdb.h"
#include "readers/vdb/vdb_open.h"

namespace pellucid::readers {
namespace {

/// NAME[I] is grid number I of those that are called NAME; it may be a name itself.
bool is_wanted(const std::string& name, const std::string& wanted) {
  return wanted.empty() || name == wanted || name == wanted.substr(0, wanted.rfind('['));
}

}  // namespace

void parse_vdb_grids(const std::filesystem::path& path, const std::string& wanted,
                     BlockWriter& out) {
  const auto file = open_vdb(path);
  int number = 0;
  for (auto name = file->beginName(); name != file->endName(); ++name) {
    openvdb::GridBase::Ptr grid = file->readGridMetadata(*name);  // *name numbers equal names
    const bool with_tree = is_wanted(grid->getName(), wanted);
    if (with_tree) grid = file->readGrid(*name);
    write_grid(number++, *grid, with_tree, out);
  }
}

}  // namespace pellucid::readers
