// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "geometry/files/mesh_file.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::FileInMemory file("input.obj",
                                       {{"input.mtl", "newmtl glass\nKd 1 0 0\nd 0.5\n"}});
  file.with({data, size});
  fuzz::attempt(file.name(), [] { geometry::read_mesh(file.path()); });
  fuzz::attempt(file.name(), [] { geometry::read_lines(file.path()); });
  return 0;
}
