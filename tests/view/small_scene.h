// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A scene file of a sheet and two lines, and what a page asks about it.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::view {

/// A SmallScene lies in a folder of its own.
class SmallScene : public ::testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "sheet.ply",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nproperty float s\nelement face 2\n"
               "property list uchar int vertex_indices\nend_header\n"
               "-1 -1 0 0\n1 -1 0 1\n1 1 0.5 2\n-1 1 0 3\n3 0 1 2\n3 0 2 3\n");
    write_text(folder_ / "lines.obj", "v -1 0 0.8\nv 1 0.1 0.8\nv 0 1 0.7\nl 1 2 3\n");
    write_text(file(), text());
  }

  std::filesystem::path file() const { return folder_ / "small.json"; }
  static std::string text() {
    return R"({ "format": "pellucid-scene", "version": 1, "resolution": [48, 32],
  "camera": { "eye": [0, 0, 4], "fov": 40 },
  "objects": [
    { "mesh": "sheet.ply", "color": {"by": "s", "map": "viridis"}, "opacity": 0.4 },
    { "lines": "lines.obj", "radius": 0.05, "color": [1, 0, 0], "opacity": 0.7,
      "halo": {"width": 0.05} } ] }
)";
  }

  /// The state of a page that looks as the file does.
  static nlohmann::json state() {
    return {{"camera", {{"eye", {0, 0, 4}}, {"fov", 40}}}, {"size", {48, 32}}};
  }

  testing::TemporaryFolder folder_;
};

}  // namespace pellucid::view
