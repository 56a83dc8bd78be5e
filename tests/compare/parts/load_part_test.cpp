// SPDX-License-Identifier: GPL-3.0-or-later
// A part that is read object by object is the part of the scene that is read whole.

#include "compare/parts/load_part.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "scene/files/scene_file.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using namespace testing;

class UnitLoadPart : public ::testing::Test {
 protected:
  UnitLoadPart() {
    geometry::TriangleMesh far = random_triangles(30, 2);
    for (Vec3& x : far.positions) x = 3.0 * x + Vec3(7, 0, 1);
    geometry::write_mesh(folder_ / "near.ply", random_triangles(50, 1));
    geometry::write_mesh(folder_ / "far.ply", far);
  }

  std::filesystem::path scene(const std::string& more) const {
    const std::filesystem::path file = folder_ / "scene.json";
    write_text(file, R"({"format": "pellucid-scene", "version": 1, "resolution": [20, 15],
                         "lighting": "headlight", "objects": [{"mesh": "near.ply"}, )" +
                         more + "]}");
    return file;
  }
  /// Returns the first object's triangles.
  static std::size_t expect_same(const std::filesystem::path& file, const scene::ViewRequest& view,
                                 const scene::PartNumber& number) {
    const auto part = load_part(file, {}, view, number);
    const auto whole = groundtruth::take_part(scene::load_scene(file, {}, view), number);
    EXPECT_EQ(part.scene.camera.eye, whole.scene.camera.eye);
    EXPECT_EQ(part.scene.camera.height, whole.scene.camera.height);
    EXPECT_EQ(part.whole.part, number);
    EXPECT_EQ(part.whole.bounds.min, whole.whole.bounds.min);
    EXPECT_EQ(part.whole.bounds.max, whole.whole.bounds.max);
    EXPECT_EQ(part.whole.depths.near, whole.whole.depths.near);
    EXPECT_EQ(part.whole.depths.far, whole.whole.depths.far);
    EXPECT_EQ(part.whole.largest, whole.whole.largest);
    EXPECT_EQ(part.whole.first_primitives, whole.whole.first_primitives);
    EXPECT_EQ(part.scene.objects.size(), whole.scene.objects.size());
    for (std::size_t i = 0; i < whole.scene.objects.size(); ++i) {
      const auto &a = part.scene.objects[i].vertices(), &b = whole.scene.objects[i].vertices();
      EXPECT_EQ(a.positions, b.positions);
      EXPECT_EQ(a.normals, b.normals);
      EXPECT_EQ(a.colors, b.colors);
    }
    return part.scene.objects.front().mesh().triangles.size();
  }

  TemporaryFolder folder_;
};

TEST_F(UnitLoadPart, ObjectByObjectIsTheSame) {
  const auto file = scene(R"({"mesh": "far.ply"}, {"dataset": "stack:layers=3"})");
  EXPECT_EQ(expect_same(file, {}, {1, 3}), 16u);
  EXPECT_EQ(expect_same(file, {.camera = "", .view = "+x"}, {3, 3}), 17u);
  EXPECT_EQ(expect_same(file, {.camera = "eye=0,0,9,height=4", .view = ""}, {2, 3}), 17u);
}

TEST_F(UnitLoadPart, OneObjectAndHalosAreTheSame) {
  write_text(folder_ / "scene.json", R"({"format": "pellucid-scene", "version": 1,
                                         "objects": [{"mesh": "near.ply"}]})");
  EXPECT_EQ(expect_same(folder_ / "scene.json", {}, {2, 2}), 25u);
  expect_same(scene(R"({"lines": {"field": "rotation", "integrator": "stream-lines:particles=5",
                                  "seed": {"from": [1, 0, 0], "to": [2, 0, 1]}, "duration": 1},
                        "radius": 0.1, "halo": {"width": 0.1}})"),
              {}, {2, 3});
}

TEST_F(UnitLoadPart, ASceneBehindTheCameraIsRefused) {
  const auto file = scene(R"({"mesh": "far.ply"})");
  EXPECT_THROW(load_part(file, {}, {.camera = "eye=0,0,50,target=0,0,60", .view = ""}, {1, 2}),
               InputError);
}

}  // namespace
}  // namespace pellucid::compare
