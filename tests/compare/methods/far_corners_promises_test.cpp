// SPDX-License-Identifier: GPL-3.0-or-later
// What every row of the method table does with shapes that reach far beyond the picture, up to
// where numbers end: it is right, or it says why not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "compare/methods/methods.h"
#include "core/error.h"
#include "core/options/names.h"
#include "tests/compare/methods/promise_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

scene::Scene perspective_scene(int width, int height) {
  scene::Scene scene = empty_scene(width, height);
  scene.camera = {};  // at z = 5
  return scene;
}

scene::SceneObject square(double size, double z, const Rgba& color) {
  return {"square", rectangle(-size, size, -size, size, z, color)};
}

const scene::MethodRow& ground_truth() { return find_row("method", "raytrace", methods()); }

/// Every exact row draws what ground truth does, and counts as many fragments.
void expect_truth(const scene::Scene& scene, const std::string& what) {
  const scene::Rendering truth = render(ground_truth(), scene, {}, true);
  EXPECT_GT(truth.stats.fragments, 0u) << what;
  for (const scene::MethodRow& row : methods()) {
    if (!is_exact(row)) continue;
    SCOPED_TRACE(std::string(row.name) + ' ' + what);
    // Wide ribbons lie within ε of each other, and would be samples of one surface.
    const RawOptions apart{{"sampled", "integrated"}};
    const scene::Rendering rendering =
        render(row, scene, row.promises.exact_without_lines ? apart : RawOptions{}, true);
    expect_same(row, truth.image, rendering.image);
    // Edges lie within a 256th of a pixel of where they should: a pixel or two.
    EXPECT_NEAR(double(rendering.stats.fragments), double(truth.stats.fragments), 3);
  }
}

TEST(PropertyFarCorners, SquaresOfAnySizeFillThePicture) {
  for (const double size : {1e2, 1e5, 1e10, 1e38, 1e39, 1e76, 1e98}) {
    scene::Scene scene = perspective_scene(16, 12);
    scene.objects = {square(size, 0, {0.2f, 0.4f, 0.8f, 0.5f}),
                     square(size, 1, {0.9f, 0.1f, 0.3f, 0.25f})};
    expect_truth(scene, fmt::format("{}", size));
  }
}

TEST(PropertyFarCorners, ScenesOfAnyScaleLookTheSame) {
  for (const double scale : {1e-290, 1e-160, 1e-76, 1e38, 1e76, 1e160, 1e290}) {
    scene::Scene scene = perspective_scene(16, 12);
    scene.camera.eye *= scale;
    scene.objects = {square(scale, 0, {0.2f, 0.4f, 0.8f, 0.5f})};
    expect_truth(scene, fmt::format("{}", scale));
  }
}

// A floor, lit, its colour and opacity growing from end to end: what is interpolated is that at the
// cuts, too.
TEST(PropertyFarCorners, AttributesAreThoseOfTheWholeTriangle) {
  for (const double size : {20.0, 100.0, 1e4}) {
    scene::Scene scene = perspective_scene(32, 24);
    scene.lighting = scene::Lighting::headlight;
    scene::SceneObject floor = square(size, 0, Rgba(1));
    geometry::TriangleMesh& mesh = floor.mesh();
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3& x = mesh.positions[i];
      x = {x.x, -1, -x.y};
      mesh.colors[i] = {0.25f * float(i), 1 - 0.25f * float(i), 0.5f, 0.2f + 0.2f * float(i)};
      mesh.normals[i] = glm::normalize(Vec3(0.2 * double(i), 1, 0.3));
    }
    scene.objects = {floor, square(1, 0, {0.2f, 0.4f, 0.8f, 0.5f})};
    expect_truth(scene, fmt::format("{}", size));
  }
}

/// A square in n × n pieces; its importance grows from the left end to the right one.
scene::SceneObject important_square(double size, double z, int n, const Rgba& color) {
  geometry::TriangleMesh mesh;
  const auto vertex = [&](int i, int j) { return std::uint32_t(i + (n + 1) * j); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      mesh.positions.emplace_back(size * (2.0 * i / n - 1), size * (2.0 * j / n - 1), z);
      mesh.colors.push_back(color);
      mesh.importance.push_back(float(i) / float(n));
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return {"square", mesh};
}

// In pieces none that is seen reaches far beyond the picture. Per fragment: elements of one square
// and of many differ.
TEST(PropertyFarCorners, ImportanceIsThatOfTheWholeTriangle) {
  scene::Scene whole = perspective_scene(16, 12), pieces = whole;
  for (int i = 0; i < 5; ++i) {
    const Rgba color(0.2f * float(i), 0.4f, 0.8f, 0.5f);
    whole.objects.push_back(important_square(50, 0.3 * i, 1, color));
    pieces.objects.push_back(important_square(50, 0.3 * i, 50, color));
  }
  const scene::MethodRow& row = find_row("method", "fourier-opacity", methods());
  const RawOptions options{{"per", "fragment"}};
  EXPECT_LE(
      largest_difference(render(row, whole, options).image, render(row, pieces, options).image),
      float_composite);
}

// A square is one element, of one importance, however large it is.
TEST(PropertyFarCorners, ElementsAreThoseOfTheWholeTriangle) {
  scene::Scene near = perspective_scene(16, 12), far = near;
  for (int i = 0; i < 5; ++i)
    for (scene::Scene* scene : {&near, &far}) {
      const double size = scene == &near ? 10 : 1000;
      scene->objects.push_back(
          important_square(size, 0.3 * i, 1, {0.2f * float(i), 0.4f, 0.8f, 0.5f}));
      scene->objects.back().vertices().importance.assign(4, float(i % 3) / 2);
    }
  for (const scene::MethodRow& row : methods()) {
    if (!row.promises.optimizes_opacity) continue;
    EXPECT_LE(largest_difference(render(row, near).image, render(row, far).image), float_composite)
        << row.name;
  }
}

TEST(PropertyFarCorners, RibbonsOfAnyWidthAreLitAcrossTheirWhole) {
  for (const double radius : {1e-3, 30.0, 1e3, 1e38, 1e76}) {
    scene::Scene scene = perspective_scene(16, 12);
    scene.lighting = scene::Lighting::headlight;
    scene::LineObject lines;
    lines.radius = radius;
    lines.set.positions = {{-1, -0.3, 0}, {1, 0.2, 0.5}, {2, 1, 0}};
    lines.set.colors = {{1, 0.5f, 0.2f, 0.5f}, {0.2f, 0.5f, 1, 0.7f}, {0.2f, 0.5f, 1, 0.7f}};
    lines.set.offsets = {0, 3};
    scene.objects = {{"lines", lines}, square(1, -1, {0.2f, 0.4f, 0.8f, 0.5f})};
    expect_truth(scene, fmt::format("{}", radius));
  }
}

// Beyond 1e9 times its distance a line's end is seen along the line, where it has no width.
TEST(PropertyFarCorners, LongLinesKeepTheirWidth) {
  for (const double length : {1e3, 1e6, 1e9}) {
    scene::Scene scene = perspective_scene(16, 12);
    scene::LineObject lines;
    lines.radius = 0.5;
    lines.set.positions = {{-length, 0.1, 0}, {length, 0.1, 0}};
    lines.set.colors.assign(2, {1, 0.5f, 0.2f, 0.5f});
    lines.set.offsets = {0, 2};
    scene.objects = {{"lines", lines}};
    expect_truth(scene, fmt::format("{}", length));
  }
}

TEST(PropertyFarCorners, APictureOfAnyAngleIsFilled) {
  for (const double fov : {1e-3, 1e-6, 1e-9}) {
    scene::Scene scene = perspective_scene(16, 12);
    scene.camera.fov = fov;
    scene.camera.target = {0.21, 0.37, 0};
    scene.objects = {square(1, 0, {0.2f, 0.4f, 0.8f, 0.5f})};
    expect_truth(scene, fmt::format("{}", fov));
  }
}

scene::Scene one_point(double radius, scene::PointObject::Profile profile) {
  scene::Scene scene = perspective_scene(8, 8);
  scene::PointObject points;
  points.radius = radius;
  points.profile = profile;
  points.set.positions = {Vec3(0)};
  points.set.colors = {Rgba(0.2f, 0.4f, 0.8f, 0.5f)};
  scene.objects = {{"points", points}};
  return scene;
}

// A disc is drawn as a triangle around it, which is not clipped.
TEST(PropertyFarCorners, DiscsAreRightOrRefused) {
  using enum scene::PointObject::Profile;
  expect_truth(one_point(1e3, disc), "1000");
  for (const double radius : {1e10, 1e38, 1e200}) {
    const scene::Scene scene = one_point(radius, disc);
    EXPECT_EQ(render(ground_truth(), scene, {}, true).stats.fragments, 64u);
    EXPECT_THROW(render(find_row("method", "linked-list", methods()), scene), InputError);
  }
}

TEST(PropertyFarCorners, WhereNumbersEndIsSaid) {
  using enum scene::PointObject::Profile;
  const double most = std::numeric_limits<double>::max();
  scene::Scene far_corner = perspective_scene(8, 8);
  far_corner.objects = {square(most, 0, Rgba(1))};
  for (const scene::MethodRow& row : methods()) {
    EXPECT_THROW(render(row, far_corner), InputError) << row.name;
    EXPECT_THROW(render(row, one_point(most, disc)), InputError) << row.name;
    EXPECT_THROW(render(row, one_point(most, sphere)), InputError) << row.name;
  }
}

}  // namespace
}  // namespace pellucid::compare
