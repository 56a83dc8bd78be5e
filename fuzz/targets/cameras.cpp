// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras of other programs, whatever their file ends in.
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "geometry/files/gltf/gltf_cameras.h"
#include "scene/cameras/paraview_cameras.h"

using namespace pellucid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::FileInMemory file("input.pvcc");
  file.with({data, size});
  fuzz::attempt(file.name(), [] { scene::read_paraview_cameras(file.path()); });
  fuzz::attempt(file.name(), [] { geometry::read_gltf_cameras(file.path()); });
  return 0;
}
