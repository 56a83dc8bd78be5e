// SPDX-License-Identifier: GPL-3.0-or-later
// Members of a .trx file as blocks, and the lines that are made of them.

#include "fuzz/support/attempt.h"
#include "fuzz/support/block_file.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/trx_tracks.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt_blocks({data, size}, [](const Blocks& blocks) {
    fuzz::refusable([&] { check_vertices("input", geometry::lines_of_trx(blocks)); });
  });
  return 0;
}
