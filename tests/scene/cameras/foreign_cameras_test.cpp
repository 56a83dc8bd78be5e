// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/cameras/foreign_cameras.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "core/files/output_file.h"
#include "scene/files/camera_file.h"
#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string property(std::string_view name, const std::vector<double>& numbers) {
  std::string text = fmt::format("<Property name=\"{}\" id=\"6.{}\">", name, name);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += fmt::format("<Element index=\"{}\" value=\"{}\"/>", i, numbers[i]);
  return text + "<Domain name=\"bool\" id=\"6.bool\"/></Property>";
}

/// A view as ParaView writes it, among other properties.
std::string view(const Vec3& eye, bool parallel) {
  return "<Proxy group=\"views\" type=\"RenderView\" id=\"6\">" + property("ViewSize", {800, 600}) +
         "<Property name=\"Representations\"><Proxy value=\"7\"/></Property>" +
         property("CameraPosition", {eye.x, eye.y, eye.z}) +
         property("CameraFocalPoint", {4, 5, 6}) + property("CameraViewUp", {0, 0, 2}) +
         property("CenterOfRotation", {9, 9, 9}) + property("CameraViewAngle", {30}) +
         property("CameraParallelScale", {1.5}) +
         property("CameraParallelProjection", {parallel ? 1. : 0.}) + "</Proxy>";
}

class UnitForeignCameras : public testing::SceneFileTest {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
    return (folder_ / name).string();
  }
  static std::string complaint(const std::string& text) {
    try {
      camera_of_text(text, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
};

TEST_F(UnitForeignCameras, ParaViewsAngleIsVerticalAndItsScaleHalfTheHeight) {
  const std::string one =
      written("v.pvcc", "<?xml version=\"1.0\"?>\n<PVCameraConfiguration version=\"1.0\">" +
                            view({1, 2, 3}, false) + "</PVCameraConfiguration>");
  const Camera camera = camera_of_text(one, {});
  EXPECT_EQ(camera.projection, Projection::perspective);
  EXPECT_EQ(camera.eye, Vec3(1, 2, 3));
  EXPECT_EQ(camera.target, Vec3(4, 5, 6));
  EXPECT_EQ(camera.up, Vec3(0, 0, 2));
  EXPECT_EQ(camera.fov, 30);
  EXPECT_TRUE(sets_eye(one));
}

TEST_F(UnitForeignCameras, OfAStateWithSeveralViewsOneIsChosen) {
  const std::string chart =
      "<Proxy group=\"views\" type=\"XYChartView\">" + property("ViewSize", {1, 1}) + "</Proxy>";
  const std::string state =
      written("s.pvsm", "<ParaView><ServerManagerState>" + chart + view({1, 2, 3}, false) +
                            view({7, 8, 9}, true) + "</ServerManagerState></ParaView>");
  EXPECT_THAT(complaint(state), AllOf(HasSubstr("it has 2 cameras"), HasSubstr("s.pvsm:1 to")));
  EXPECT_THAT(complaint(state + ":3"), HasSubstr("it has 2 cameras"));
  EXPECT_THAT(complaint(state + ":0"), HasSubstr("'0'; accepted: which camera"));
  const Camera camera = camera_of_text(state + ":2", {});
  EXPECT_EQ(camera.projection, Projection::orthographic);
  EXPECT_EQ(camera.eye, Vec3(7, 8, 9));
  EXPECT_EQ(camera.height, 3);
}

/// A quarter turn about y and a shift stand above the camera's own shift along its x: its x axis is
/// the world's -z, and it looks along the world's -x.
TEST_F(UnitForeignCameras, AGltfCameraStandsWhereItsNodesPutIt) {
  const double half = std::numbers::sqrt2 / 2;
  const std::string nodes = fmt::format(
      R"("nodes": [{{"children": [1, 2], "rotation": [0, {0}, 0, {0}], "translation": [1, 2, 3]}},
                   {{"camera": 0, "translation": [5, 0, 0], "scale": [2, 2, 2]}}, {{"camera": 1}}])",
      half);
  const std::string file = written(
      "c.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], )" + nodes + R"(,
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}},
                    {"type": "orthographic",
                     "orthographic": {"xmag": 9, "ymag": 2, "znear": 0, "zfar": 1}}]})");
  const Camera first = camera_of_text(file + ":1", {}), second = camera_of_text(file + ":2", {});
  EXPECT_LE(glm::length(first.eye - Vec3(1, 2, -2)), 1e-14);
  EXPECT_LE(glm::length(first.target - first.eye - Vec3(-1, 0, 0)), 1e-14);
  EXPECT_LE(glm::length(first.up - Vec3(0, 1, 0)), 1e-14);
  EXPECT_NEAR(first.fov, 0.5 * 180 / std::numbers::pi, 1e-12);
  EXPECT_EQ(second.projection, Projection::orthographic);
  EXPECT_EQ(second.height, 4);
}

TEST_F(UnitForeignCameras, ASceneNamesThemFromItsFolder) {
  written("v.pvcc", "<P>" + view({1, 2, 3}, false) + "</P>");
  EXPECT_EQ(with(sheet, R"("camera": "v.pvcc")").camera.eye, Vec3(1, 2, 3));
  EXPECT_THAT(refusal(sheet, R"("camera": "v.pvcd")"),
              HasSubstr("camera: 'v.pvcd'; accepted: a camera's keys, or a file ending in .pvcc"));
}

TEST_F(UnitForeignCameras, FilesThatAreNoneAreRefused) {
  EXPECT_THAT(complaint(written("v.pvcc", "<a><b></a>")), HasSubstr("v.pvcc:1: mismatched tag"));
  EXPECT_THAT(complaint(written("v.pvcc", "")), HasSubstr("no element found"));
  EXPECT_THAT(complaint(written("v.pvcc", "<a/>")), HasSubstr("it has no camera"));
  std::string lacking = "<a>" + view({1, 2, 3}, false) + "</a>";
  lacking.erase(lacking.find("<Element index=\"1\" value=\"5\"/>"), 30);
  EXPECT_THAT(complaint(written("v.pvcc", lacking)),
              HasSubstr("a view's CameraFocalPoint is not there"));
  EXPECT_THAT(complaint(written("c.gltf", R"({"asset": {"version": "2.0"}})")),
              HasSubstr("it has no camera"));
  EXPECT_THAT(
      complaint(written("c.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
                  "nodes": [{"camera": 0}], "cameras": [{"type": "perspective"}]})")),
      HasSubstr("not as glTF has it"));
  EXPECT_THAT(complaint((folder_ / "none.glb").string()), HasSubstr("none.glb"));
}

}  // namespace
}  // namespace pellucid::scene
