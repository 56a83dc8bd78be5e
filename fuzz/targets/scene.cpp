// SPDX-License-Identifier: GPL-3.0-or-later
// The scene file, with a few files of geometry and a field beside it. What takes long is left out,
// for it is not read but made: data sets, and integration beyond a few steps.

#include <nlohmann/json.hpp>

#include "core/files/json_text.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "scene/files/scene_file.h"

using namespace pellucid;

namespace {

const fuzz::FileInMemory& scene_file() {
  static const fuzz::FileInMemory file(
      "input.json", {{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nl 1 2 3\n"},
                     {"a.csv", "x,y,z,s\n0,0,0,1\n1,0,0,2\n"},
                     {"a.mha",
                      "NDims = 3\nDimSize = 2 2 2\nElementNumberOfChannels = 3\n"
                      "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
                          std::string(96, '?')}});
  return file;
}

/// Whether the scene asks for a data set; makes its integration short.
bool takes_long(nlohmann::json& node) {
  if (node.is_object() && node.contains("dataset")) return true;
  if (node.is_object() && node.contains("integrator") && node["integrator"].is_string())
    node["integrator"] = node["integrator"].get<std::string>().find("lines") != std::string::npos
                             ? "stream-lines:particles=2,max-steps=20"
                             : "fixed-front:particles=3,max-steps=20,max-triangles=1000";
  return node.is_structured() && std::any_of(node.begin(), node.end(), takes_long);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::FileInMemory& file = scene_file();
  fuzz::attempt(file.name(), [&] {
    nlohmann::json scene = read_json(file.with({data, size}));
    if (takes_long(scene)) return;
    scene::load_scene(file.with(fuzz::bytes_of(json_text(scene))));
  });
  return 0;
}
