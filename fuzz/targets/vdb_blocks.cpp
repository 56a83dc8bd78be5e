// SPDX-License-Identifier: GPL-3.0-or-later
// Grids and points as blocks, and the fields, levels and points that are made of them.

#include "fields/levels/vdb_levels.h"
#include "fields/readers/vdb_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/block_file.h"
#include "fuzz/support/use_field.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/point_blocks.h"
#include "readers/vdb/grid_blocks.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt_blocks({data, size}, [](const Blocks& blocks) {
    fuzz::refusable([&] { check_vertices("input", geometry::points_of(blocks)); });
    fuzz::attempt(
        "input", [&] { fuzz::use(*fields::field_of(readers::grids_of(blocks), {}, "input.vdb")); });
    for (const char* scalar : {"s", "magnitude", "q"})
      fuzz::attempt("input", [&] {
        fields::levels_of(readers::grids_of(blocks), "input.vdb", scalar);  // empties grids
      });
  });
  return 0;
}
