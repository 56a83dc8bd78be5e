// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a scene is crossed as the whole is: the same bits, the same numbers, none twice.

#include "groundtruth/traversal/scene_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "core/error.h"
#include "groundtruth/sums/picture_sums.h"
#include "tests/support/part_scenes.h"

namespace pellucid::groundtruth {
namespace {

using testing::kinds_of_parts;
using testing::ScenesOfKind;

/// What a merge has to know of a layer.
auto traits(const RayLayer& layer) {
  return std::tuple(layer.depth, layer.object, layer.primitive, layer.opacity, layer.color.r,
                    layer.color.g, layer.color.b, layer.importance, layer.d);
}

/// A pixel's layers, pixel by pixel.
using Picture = std::vector<std::vector<RayLayer>>;

Picture layers_of(const scene::Scene& scene, const RayProbe& probe) {
  Picture picture;
  for (int y = 0; y < scene.height; ++y)
    for (RaySums& ray : row_sums(scene, probe, y)) picture.push_back(std::move(ray.layers));
  return picture;
}

/// Orders the layers that all parts have of a pixel, and drops those behind the first opaque one.
void merge(const scene::Scene& scene, std::vector<RayLayer>& layers) {
  std::ranges::stable_sort(layers, [](const RayLayer& p, const RayLayer& q) {
    return std::tie(p.depth, p.object, p.primitive) < std::tie(q.depth, q.object, q.primitive);
  });
  const auto last = std::ranges::find_if(
      layers, [&](const RayLayer& layer) { return scene.objects[layer.object].opaque; });
  if (last != layers.end()) layers.erase(last + 1, layers.end());
}

Picture merged(const scene::Scene& scene, int parts) {
  Picture picture(std::size_t(scene.width) * scene.height);
  for (int part = 1; part <= parts; ++part) {
    const ScenePart cut = take_part(scene, {part, parts});
    const Picture some = layers_of(cut.scene, RayProbe(cut));
    for (std::size_t i = 0; i < picture.size(); ++i)
      picture[i].insert(picture[i].end(), some[i].begin(), some[i].end());
  }
  for (auto& layers : picture) merge(scene, layers);
  return picture;
}

void expect_parts_make_up(const scene::Scene& scene, int parts) {
  const Picture whole = layers_of(scene, RayProbe(scene)), sum = merged(scene, parts);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    ASSERT_EQ(sum[i].size(), whole[i].size()) << scene.name << ", pixel " << i;
    for (std::size_t k = 0; k < whole[i].size(); ++k)
      ASSERT_EQ(traits(sum[i][k]), traits(whole[i][k])) << scene.name << ", pixel " << i;
    crossings += whole[i].size();
  }
  EXPECT_GT(crossings, whole.size() / 64) << scene.name;  // it is a test of something
}

TEST(PropertyScenePart, PartsOfEveryKindMakeUpTheWhole) {
  for (const ScenesOfKind& kind : kinds_of_parts)
    for (std::uint32_t seed = 0; seed < 4; ++seed)
      expect_parts_make_up(scene_of_kind(kind, seed), seed == 0 ? 2 : int(3 * seed));
}

TEST(PropertyScenePart, PartsOfAllKindsMakeUpTheWhole) {
  for (std::uint32_t seed = 0; seed < 4; ++seed)
    for (const int parts : {1, 4, 300})
      expect_parts_make_up(testing::scene_of_all_kinds(seed), parts);
}

// Far away from the origin and the eye the bounds on rounding decide what is computed again.
TEST(PropertyScenePart, PartsOfAFarSceneMakeUpTheWhole) {
  scene::Scene scene = testing::scene_of_kind(kinds_of_parts[0], 2);
  for (scene::SceneObject& object : scene.objects) {
    geometry::TriangleMesh& mesh = object.mesh();
    for (Vec3& x : mesh.positions) x = x * 1e-6 + 1e3;
    // One triangle is large, so that the others' parts would have other bounds.
    mesh.positions.insert(mesh.positions.end(), {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    mesh.colors.insert(mesh.colors.end(), 3, Rgba(0.5));
    mesh.normals.insert(mesh.normals.end(), 3, Vec3(0, 0, 1));
    const auto first = std::uint32_t(mesh.positions.size() - 3);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  scene.camera = {.eye = Vec3(1e3, 1e3, 1e3 + 5e-6), .target = Vec3(1e3)};
  expect_parts_make_up(scene, 5);
}

// Equal depths come from different parts: each has to give them the same bits.
TEST(PropertyScenePart, PartsOfSheetsInOnePlaneMakeUpTheWhole) {
  using Cut = std::array<std::array<std::uint32_t, 3>, 2>;
  geometry::TriangleMesh sheet;
  for (const Vec2& p : {Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)})
    sheet.positions.push_back({p.x, p.y, p.x / 2 + p.y / 4});
  sheet.colors.assign(4, Rgba(0.5));
  sheet.normals.assign(4, Vec3(0, 0, 1));
  scene::Scene scene;
  scene.width = scene.height = 24;
  scene.camera = {.eye = {1, 2, 5}, .fov = 20};
  for (const bool opaque : {false, true}) {
    scene.objects.clear();
    for (const Cut& cut :
         {Cut{{{0, 1, 2}, {0, 2, 3}}}, {{{1, 3, 0}, {3, 1, 2}}}, {{{2, 0, 1}, {2, 3, 0}}}}) {
      sheet.triangles.assign(cut.begin(), cut.end());
      scene.objects.push_back({"", sheet});
      scene.objects.back().opaque = opaque;
    }
    for (const int parts : {2, 5}) expect_parts_make_up(scene, parts);
  }
}

TEST(UnitScenePart, ASceneBehindTheCameraIsRefused) {
  scene::Scene scene = testing::scene_of_kind(kinds_of_parts[0], 0);
  scene.camera = {.eye = Vec3(0, 0, 5), .target = Vec3(0, 0, 6)};
  EXPECT_THROW(take_part(scene, {1, 2}), InputError);
}

}  // namespace
}  // namespace pellucid::groundtruth
