// SPDX-License-Identifier: GPL-3.0-or-later
// Colours and normals that the progressive tree averages before it lights them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

/// Two sheets at about one depth, whose normals are turned about y by so many degrees; lit, and
/// merged into one layer.
scene::Scene turned_sheets(double degrees, double other_degrees, scene::Lighting lighting) {
  scene::Scene scene = empty_scene(9, 9);
  scene.lighting = lighting;
  for (const double angle : {degrees, other_degrees}) {
    scene::SceneObject object = sheet(scene.objects.empty() ? 0.5 : 0.499, Rgba(0.8, 0.6, 0.4, 1));
    const double radians = angle * std::numbers::pi / 180;
    object.mesh().normals.assign(object.mesh().positions.size(),
                                 Vec3(std::sin(radians), 0, std::cos(radians)));
    scene.objects.push_back(object);
  }
  scene.objects.push_back(sheet(-0.5, Rgba(1)));  // so that the scene has a depth
  scene.objects.back().mesh().normals.assign(4, Vec3(0, 0, 1));
  return scene;
}

Rgba middle_of(const scene::Scene& scene, const char* average) {
  const RawOptions options = {
      {"sampled", "all"}, {"unit", "normalized"}, {"epsilon2", "1e-3"}, {"average", average}};
  return render(method("tree"), scene, options).image.at(4, 4);
}

// The mean of normals at 30° to either side looks at the eye, whatever light each alone has; at 60°
// and 0° the mean is at 30°.
TEST(UnitTree, AttributesAreAveragedBeforeTheyAreLit) {
  const scene::Scene opposite = turned_sheets(30, -30, scene::Lighting::headlight);
  EXPECT_NEAR(middle_of(opposite, "color").r, 0.8 * std::sqrt(0.75), 1e-6);
  EXPECT_NEAR(middle_of(opposite, "attributes").r, 0.8, 1e-4);  // normals have 5e-5
  const scene::Scene one_side = turned_sheets(60, 0, scene::Lighting::headlight);
  EXPECT_NEAR(middle_of(one_side, "color").r, 0.6, 1e-6);
  EXPECT_NEAR(middle_of(one_side, "attributes").r, 0.8 * std::sqrt(0.75), 1e-4);
}

// A layer's fragments may be of both: there is no light for it.
TEST(UnitTree, AttributesOfObjectsThatAreLitOtherwiseAreRefused) {
  scene::Scene scene = turned_sheets(60, 0, scene::Lighting::headlight);
  scene.objects[0].lighting = scene::Lighting::phong;
  const RawOptions options = {{"average", "attributes"}};
  EXPECT_THROW(render(method("tree"), scene, options), InputError);
  scene.objects[0].lighting = scene::Lighting::headlight;
  render(method("tree"), scene, options);
}

// Normals of either side are those of one surface: 30° and 30° + 180°.
TEST(UnitTree, NormalsOfEitherSideDoNotCancel) {
  const scene::Scene scene = turned_sheets(30, 210, scene::Lighting::headlight);
  EXPECT_NEAR(middle_of(scene, "attributes").r, 0.8 * std::sqrt(0.75), 1e-4);
}

// One normal within each layer: lit before or after, in every lighting and from any pixel.
TEST(PropertyTree, EqualNormalsAreLitAlikeBeforeAndAfter) {
  for (const auto lighting :
       {scene::Lighting::none, scene::Lighting::headlight, scene::Lighting::phong})
    for (const bool perspective : {false, true}) {
      scene::Scene scene = turned_sheets(35, 35, lighting);
      if (perspective) {
        scene.camera.projection = scene::Projection::perspective;
        scene.camera.eye = Vec3(0.4, 0.3, 2);
        scene.camera.fov = 50;
      }
      scene::LineObject lines;  // a ribbon is lit across
      lines.radius = 0.2;
      lines.set.positions = {{-0.5, 0.1, 0.7}, {0.5, 0.2, 0.8}};
      lines.set.colors.assign(2, Rgba(0.3, 0.7, 0.9, 0.5));
      lines.set.offsets = {0, 2};
      scene.objects.push_back({"line", lines});
      const RawOptions color = {{"sampled", "all"}, {"epsilon2", "0"}};
      RawOptions attributes = color;
      attributes["average"] = "attributes";
      // Normals have 5e-5, of which a highlight's slope makes ten times as much.
      EXPECT_LE(largest_difference(render(method("tree"), scene, color).image,
                                   render(method("tree"), scene, attributes).image),
                5e-4)
          << int(lighting) << perspective;
    }
}

}  // namespace
}  // namespace pellucid::oit
