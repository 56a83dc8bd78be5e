// SPDX-License-Identifier: GPL-3.0-or-later
// What a control sets is what the scene file would have said, of isosurfaces too.
#include "scene/files/scene_file.h"
#include "tests/view/small_scene.h"
#include "view/scenes/viewed_scene.h"

namespace pellucid::view {
namespace {

class UnitControls : public SmallScene {
 protected:
  void write_isosurface(const std::string& value, const std::string& more) const {
    write_text(file(), R"({"format": "pellucid-scene", "version": 1, "objects": [{"isosurface":
      {"dataset": "sphere-levels:levels=1", "scalar": "magnitude", "value": )" +
                           value + more + "}, \"opacity\": 0.5}]}");
  }
  ViewState state_with(RawOptions settings) const {
    const nlohmann::json text = state();
    ViewState state = read_view_state(JsonNode("request", text));
    state.objects = {std::move(settings)};
    return state;
  }
};

TEST_F(UnitControls, AnIsovalueIsWithinTheSamplesBounds) {
  write_isosurface("0.9", "");
  const auto controls = ViewedScene(file()).description()["objects"][0]["controls"];
  ASSERT_EQ(controls[1]["name"], "isovalue");
  EXPECT_EQ(controls[1]["default"], "0.9");
  EXPECT_LE(controls[1]["min"], 0.5);
  EXPECT_GE(controls[1]["max"], 1);
}

TEST_F(UnitControls, AnIsosurfaceTakesAnotherValue) {
  write_isosurface("0.9", "");
  ViewedScene viewed(file());
  const scene::SceneObject& object =
      viewed.look(state_with({{"isovalue", "0.8"}, {"opacity", "0.25"}})).objects[0];
  EXPECT_EQ(std::get<scene::Isosurface>(object.shape).value, 0.8);
  for (const Rgba& color : object.vertices().colors) EXPECT_EQ(color.a, 0.25f);
}

// Its triangles are those of the value.
TEST_F(UnitControls, AnExtractedIsosurfaceIsExtractedAgain) {
  write_isosurface("0.9", ", \"mesh\": true");
  ViewedScene viewed(file());
  const auto seen = viewed.look(state_with({{"isovalue", "0.8"}})).objects[0];
  write_isosurface("0.8", ", \"mesh\": true");
  const scene::Scene expected = scene::load_scene(file());
  EXPECT_TRUE(seen.mesh().positions == expected.objects[0].mesh().positions);
  EXPECT_TRUE(seen.mesh().triangles == expected.objects[0].mesh().triangles);
  EXPECT_EQ(seen.name, expected.objects[0].name);
  EXPECT_FALSE(viewed.look(state_with({})).objects[0].mesh().positions == seen.mesh().positions);
}

TEST_F(UnitControls, RadiiByAScalarAreScaled) {
  write_text(folder_ / "p.csv", "x,y,z,r\n0,0,0,0.25\n2,0,0,1\n");
  write_text(file(), R"({"format": "pellucid-scene", "version": 1,
      "objects": [{"points": "p.csv", "radius": {"by": "r"}}]})");
  ViewedScene viewed(file());
  const auto controls = viewed.description()["objects"][0]["controls"];
  ASSERT_EQ(controls[1]["name"], "radius-scale");
  EXPECT_EQ(controls[1]["default"], "1");
  const auto seen = viewed.look(state_with({{"radius-scale", "3"}})).objects[0];
  EXPECT_EQ(seen.radii().at(0), 0.75);
  EXPECT_EQ(seen.radii().at(1), 3);
}

}  // namespace
}  // namespace pellucid::view
