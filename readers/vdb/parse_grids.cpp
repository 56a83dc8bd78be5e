// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/options/split.h"
#include "readers/vdb/grid_blocks.h"
#include "readers/vdb/parse_vdb.h"
#include "readers/vdb/vdb_open.h"

namespace pellucid::readers {
namespace {

/// NAME[I] is grid number I of those that are called NAME; it may be a name itself.
bool is_called(const std::string& name, std::string_view wanted) {
  return name == wanted || name == wanted.substr(0, wanted.rfind('['));
}

bool is_wanted(const std::string& name, const std::string& wanted) {
  if (wanted.empty() || is_called(name, wanted)) return true;
  return std::ranges::any_of(split(wanted, ','),
                             [&](std::string_view one) { return is_called(name, one); });
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
