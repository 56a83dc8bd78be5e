// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <fstream>

#include "core/error.h"
#include "geometry/files/mesh_file.h"
#include "scene/files/scene_file.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::testing {

/// A folder with a mesh, for scene files that are read or refused.
class SceneFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    geometry::TriangleMesh mesh = full_layer(0, Rgba(0.25, 0.5, 0.75, 0.125));
    mesh.scalars["speed"] = {0, 1, 2, 4};
    geometry::write_mesh(folder_ / "sheet.ply", mesh);
  }

  scene::Scene load(const std::string& text) const {
    std::ofstream(folder_ / "scene.json") << text;
    return scene::load_scene(folder_ / "scene.json");
  }
  /// A scene with the given objects and further top-level keys ("\"key\": value, …").
  scene::Scene with(const std::string& objects, const std::string& keys = "") const {
    return load(R"({"format": "pellucid-scene", "version": 1, )" + keys +
                (keys.empty() ? "" : ", ") + R"("objects": [)" + objects + "]}");
  }
  template <class... Texts>
  std::string refusal(const Texts&... texts) const {
    try {
      with(texts...);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << "the scene was accepted";
    return {};
  }

  const std::string sheet = R"({"mesh": "sheet.ply"})";
  TemporaryFolder folder_;
};

}  // namespace pellucid::testing
