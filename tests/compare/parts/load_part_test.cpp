// SPDX-License-Identifier: GPL-3.0-or-later
// A part that is read object by object is the part of the scene that is read whole.

#include "compare/parts/load_part.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "geometry/files/mesh_file.h"
#include "scene/files/scene_file.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;
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
  // Of 50 + 30 + 6 triangles, 28 or 29 each.
  EXPECT_EQ(expect_same(file, {}, {1, 3}), 28u);
  EXPECT_EQ(expect_same(file, {.camera = "", .view = "+x"}, {3, 3}), 0u);
  EXPECT_EQ(expect_same(file, {.camera = "eye=0,0,9,height=4", .view = ""}, {2, 3}), 22u);
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

/// A part with bounds is the part without, but for what it does not read.
TEST_F(UnitLoadPart, WithBoundsOnlyWhatThePartHasIsRead) {
  const auto file = scene(R"({"mesh": "far.ply", "opaque": true}, {"dataset": "stack:layers=3"})");
  for (const scene::ViewRequest& view :
       {scene::ViewRequest(), scene::ViewRequest{.camera = "eye=0,0,9,height=4", .view = ""}}) {
    const SceneBounds bounds = measure_bounds(file, view, {});
    EXPECT_EQ(bounds.counts, (std::vector<std::uint64_t>{50, 30, 6}));
    for (const auto of : {scene::PartOf::all_objects, scene::PartOf::transparent_objects})
      for (int number = 1; number <= 4; ++number) {
        const FilesRead read;
        const auto part = load_part(file, {}, view, {number, 4}, of, &bounds);
        const bool reads_near = read.paths().contains(folder_ / "near.ply");
        const auto other = load_part(file, {}, view, {number, 4}, of);
        EXPECT_EQ(part.scene.camera.eye, other.scene.camera.eye);
        EXPECT_EQ(part.whole.bounds.min, other.whole.bounds.min);
        EXPECT_EQ(part.whole.bounds.max, other.whole.bounds.max);
        EXPECT_EQ(part.whole.depths.near, other.whole.depths.near);
        EXPECT_EQ(part.whole.depths.far, other.whole.depths.far);
        EXPECT_EQ(part.whole.largest, other.whole.largest);
        ASSERT_EQ(part.scene.objects.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
          const auto &a = part.scene.objects[i].mesh(), &b = other.scene.objects[i].mesh();
          EXPECT_EQ(a.positions, b.positions);
          EXPECT_EQ(a.normals, b.normals);
          EXPECT_EQ(a.triangles, b.triangles);
          EXPECT_EQ(part.scene.objects[i].opaque, i == 1);
          EXPECT_TRUE(a.triangles.empty() ||
                      part.whole.first_primitives[i] == other.whole.first_primitives[i]);
        }
        EXPECT_EQ(reads_near, !part.scene.objects[0].mesh().triangles.empty());
      }
  }
}

TEST_F(UnitLoadPart, BoundsReadBackAsTheyWere) {
  const auto file = scene(R"({"mesh": "far.ply"})");
  SceneBounds bounds = measure_bounds(file, {}, {});
  bounds.depths.near = 1.0 / 3;
  bounds.largest = 1e-300 / 3;
  write_bounds(folder_ / "bounds.json", bounds);
  const SceneBounds again = read_bounds(folder_ / "bounds.json");
  EXPECT_EQ(again.fingerprint, bounds.fingerprint);
  EXPECT_EQ(again.files, bounds.files);
  EXPECT_EQ(again.camera, bounds.camera);
  EXPECT_EQ(again.box.min, bounds.box.min);
  EXPECT_EQ(again.box.max, bounds.box.max);
  EXPECT_EQ(again.depths.near, bounds.depths.near);
  EXPECT_EQ(again.depths.far, bounds.depths.far);
  EXPECT_EQ(again.largest, bounds.largest);
  EXPECT_EQ(again.counts, bounds.counts);
}

TEST_F(UnitLoadPart, BoundsOfAnotherSceneOrViewAreRefused) {
  const auto file = scene(R"({"mesh": "far.ply"})");
  const SceneBounds bounds = measure_bounds(file, {}, {});
  const auto error = [&](const scene::ViewRequest& view) {
    try {
      load_part(file, {}, view, {1, 2}, scene::PartOf::all_objects, &bounds);
    } catch (const InputError& wrong) {
      return std::string(wrong.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(error({}), "none");
  EXPECT_THAT(error({.camera = "eye=0,0,9,height=4", .view = ""}), HasSubstr("--bounds are of"));
  EXPECT_THAT(error({.camera = "", .view = "+x"}), HasSubstr("--view: beside --bounds"));
  geometry::write_mesh(folder_ / "near.ply", random_triangles(50, 9));
  EXPECT_THAT(error({}), HasSubstr("near.ply: --bounds are not of it: it has changed"));
  scene(R"({"mesh": "far.ply"}, {"dataset": "stack"})");
  EXPECT_THAT(error({}), HasSubstr("of 2 objects, the scene has 3"));
}

TEST_F(UnitLoadPart, HalosHaveNoBounds) {
  const auto file =
      scene(R"({"lines": {"field": "rotation", "integrator": "stream-lines:particles=5",
                          "seed": {"from": [1, 0, 0], "to": [2, 0, 1]}, "duration": 1},
                "radius": 0.1, "halo": {"width": 0.1}})");
  EXPECT_THROW(measure_bounds(file, {}, {}), InputError);
}

TEST_F(UnitLoadPart, ASceneBehindTheCameraIsRefused) {
  const auto file = scene(R"({"mesh": "far.ply"})");
  EXPECT_THROW(load_part(file, {}, {.camera = "eye=0,0,50,target=0,0,60", .view = ""}, {1, 2}),
               InputError);
}

}  // namespace
}  // namespace pellucid::compare
