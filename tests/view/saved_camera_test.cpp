// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/scenes/saved_camera.h"

#include "core/error.h"
#include "core/files/json_text.h"
#include "scene/files/scene_file.h"
#include "tests/view/small_scene.h"

namespace pellucid::view {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

scene::Camera other_camera() {
  scene::Camera camera;
  camera.eye = {1, 2, 3};
  camera.fov = 30;
  return camera;
}

constexpr const char* written =
    R"({ "type": "perspective", "eye": [1.0, 2.0, 3.0], "target": [0.0, 0.0, 0.0], )"
    R"("up": [0.0, 1.0, 0.0], "fov": 30.0 })";

using UnitSavedCamera = SmallScene;

TEST_F(UnitSavedCamera, ChangesNothingElse) {
  std::string expected = text();
  const std::string before = R"({ "eye": [0, 0, 4], "fov": 40 })";
  expected.replace(expected.find(before), before.size(), written);
  EXPECT_EQ(with_camera("f", text(), other_camera()), expected);
}

TEST_F(UnitSavedCamera, ComesBeforeTheFirstKeyWhereThereWasNone) {
  EXPECT_EQ(with_camera("f", "{\n  \"objects\": []}", other_camera()),
            std::string("{\n  \"camera\": ") + written + ",\n  \"objects\": []}");
}

// The word also stands in other places: in a text, in another key, deeper, escaped.
TEST_F(UnitSavedCamera, IsTheOutermostKeyAndNoOther) {
  const std::string text =
      R"({"a": "\"camera\": {", "camera_path": {"camera": 1}, "b": [{"camera": 2}], )"
      R"("cam\u0065ra" : {"eye": [0, 0, 9]} , "c": "}"})";
  const auto changed = parse_json("f", with_camera("f", text, other_camera()));
  EXPECT_EQ(changed["camera"]["eye"], nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(changed["camera_path"]["camera"], 1);
  EXPECT_EQ(changed["b"][0]["camera"], 2);
  EXPECT_EQ(changed.size(), 5u);
}

TEST_F(UnitSavedCamera, IsWhatTheSceneIsThenSeenBy) {
  save_camera(file(), other_camera());
  const scene::Scene scene = scene::load_scene(file());
  EXPECT_EQ(scene.camera.eye, Vec3(1, 2, 3));
  EXPECT_EQ(scene.camera.fov, 30);
}

TEST_F(UnitSavedCamera, StandsBehindTheOtherViewsOfAStudy) {
  EXPECT_EQ(
      with_view("f", R"({"views": [{"eye": [0, 0, 1]} ], "title": "]"})", other_camera()),
      std::string(R"({"views": [{"eye": [0, 0, 1]},)") + "\n  " + written + R"( ], "title": "]"})");
  EXPECT_EQ(with_view("f", R"({"views": [ ]})", other_camera()),
            std::string(R"({"views": [)") + written + R"( ]})");
  EXPECT_EQ(with_view("f", R"({"title": "views"})", other_camera()),
            std::string(R"({"views": [)") + written + "],\n  \"title\": \"views\"}");
  for (const char* text : {R"({"views": 3})", R"({"views": "path"})", "[1]", "{"})
    EXPECT_THROW(with_view("f", text, other_camera()), InputError) << text;
}

TEST_F(UnitSavedCamera, LeavesWhatIsNoSceneAlone) {
  for (const char* text : {"[1, 2]", "{\"a\": ", "", "{\"a\": 1} x"})
    EXPECT_THROW(with_camera("f", text, other_camera()), InputError) << text;
}

}  // namespace
}  // namespace pellucid::view
