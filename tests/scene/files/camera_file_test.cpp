// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/camera_file.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "scene/view/camera_fit.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::HasSubstr;

void expect_equal(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.projection, b.projection);
  EXPECT_EQ(a.eye, b.eye);
  EXPECT_EQ(a.target, b.target);
  EXPECT_EQ(a.up, b.up);
  EXPECT_EQ(a.projection == Projection::perspective ? a.fov : a.height,
            b.projection == Projection::perspective ? b.fov : b.height);
}

std::string refusal(std::string_view text) {
  try {
    camera_of_text(text, {});
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << text << " was accepted";
  return {};
}

TEST(UnitCameraText, SetsWhatItNamesAndLeavesTheRest) {
  const Camera own{.eye = {1, 2, 3}, .target = {4, 5, 6}, .up = {0, 0, 1}, .fov = 20};
  Camera camera = camera_of_text("eye=-1,0.5,1e3,fov=60", own);
  EXPECT_EQ(camera.eye, Vec3(-1, 0.5, 1000));
  EXPECT_EQ(camera.target, own.target);
  EXPECT_EQ(camera.up, own.up);
  EXPECT_EQ(camera.fov, 60);
  camera = camera_of_text("height=3", own);
  EXPECT_EQ(camera.projection, Projection::orthographic);
  EXPECT_EQ(camera.height, 3);
}

TEST(UnitCameraText, WhatIsPrintedReadsBackAsTheSame) {
  const Camera perspective{.eye = {0.1, 1.0 / 3, 1e-17}, .target = {1e10, -2, 0}, .fov = 33.3};
  Camera orthographic = perspective;
  orthographic.projection = Projection::orthographic;
  orthographic.height = 1.0 / 7;
  for (const Camera& camera : {perspective, orthographic}) {
    expect_equal(camera_of_text(camera_text(camera), {}), camera);
    const nlohmann::json json = camera_json(camera);
    expect_equal(read_camera(JsonNode("file", json)), camera);
  }
}

TEST(UnitCameraText, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refusal("eyes=1,2,3"), HasSubstr("unknown key 'eyes'; known: eye"));
  EXPECT_THAT(refusal("1,2,3"), HasSubstr("'1'; accepted: KEY=VALUES"));
  EXPECT_THAT(refusal("eye=1,2"), HasSubstr("eye=1,2; accepted: three numbers"));
  EXPECT_THAT(refusal("eye=1,2,x"), HasSubstr("'x'; accepted: a finite number"));
  EXPECT_THAT(refusal("eye=1,2,inf"), HasSubstr("'inf'"));
  EXPECT_THAT(refusal("fov=1,fov=2"), HasSubstr("given twice"));
  EXPECT_THAT(refusal("fov=1,height=2"), HasSubstr("one of fov"));
}

class UnitViewRequest : public testing::SceneFileTest {
 protected:
  Scene seen(const ViewRequest& view, const std::string& keys = "") const {
    with(sheet, keys);
    return load_scene(folder_ / "scene.json", {}, view);
  }
};

TEST_F(UnitViewRequest, GoesBeforeTheFile) {
  const std::string keys =
      R"("camera": {"eye": [0, 0, 9], "fov": 20}, "resolution": [7, 5], "samples": 3)";
  const Scene own = seen({}, keys);
  EXPECT_EQ(own.camera.eye, Vec3(0, 0, 9));
  EXPECT_EQ(own.provenance.at("camera"), "the scene file's");
  const Scene asked =
      seen({.camera = "eye=0,0,4", .view = "", .resolution = {{60, 40}}, .samples = 2}, keys);
  EXPECT_EQ(asked.camera.eye, Vec3(0, 0, 4));
  EXPECT_EQ(asked.camera.fov, 20);
  EXPECT_EQ(asked.width, 60);
  EXPECT_EQ(asked.height, 40);
  EXPECT_EQ(asked.samples, PixelSampling{.per_axis = 2});
}

TEST_F(UnitViewRequest, AViewSeesAllInTheSizeThatIsAskedFor) {
  const Scene square = seen({.camera = "", .view = "+z"}, R"("camera": {"fov": 20})");
  EXPECT_EQ(square.camera.fov, 20);
  EXPECT_EQ(square.camera.eye.x, square.camera.target.x);
  EXPECT_GT(square.camera.eye.z, square.camera.target.z);
  // Where a picture is half as wide as high, its width decides: twice as far, up to the tangents.
  const Scene narrow =
      seen({.camera = "", .view = "+z", .resolution = {{50, 100}}}, R"("camera": {"fov": 20})");
  EXPECT_NEAR(narrow.camera.eye.z / square.camera.eye.z, 2, 1e-14);
}

TEST_F(UnitViewRequest, WithoutACameraInTheFileTheAngleIsTakenAndAllIsSeen) {
  const Scene wide = seen({.camera = "fov=90", .view = ""});
  const Scene usual = seen({});
  EXPECT_EQ(wide.camera.fov, 90);
  EXPECT_LT(glm::length(wide.camera.eye), glm::length(usual.camera.eye));
  EXPECT_THAT(usual.provenance.at("camera"), HasSubstr("fitted to the scene"));
}

TEST_F(UnitViewRequest, WrongOnesAreRefused) {
  EXPECT_THROW(seen({.camera = "", .view = "x"}), InputError);
  EXPECT_THROW(seen({.camera = "eye=0,0,0,target=0,0,0", .view = ""}), InputError);
}

}  // namespace
}  // namespace pellucid::scene
