// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <openvdb/openvdb.h>

#include <string>
#include <string_view>

#include "core/error.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/support/levels.h"

namespace pellucid::testing {

/// Returns what a .vdb file of that grid is refused with when its levels of the scalar are read; ""
/// when it is not.
inline std::string refusal(const openvdb::GridBase::Ptr& grid, std::string_view scalar = "p") {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write({grid});
  try {
    read_float_levels(folder / "levels.vdb", scalar);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace pellucid::testing
