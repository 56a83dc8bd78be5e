// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/methods/raytrace.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::groundtruth {
namespace {

using namespace testing;

scene::Rendering trace(const scene::Scene& scene, const RawOptions& options = {}) {
  return render(raytrace_method(), scene, options, true);
}

/// Largest difference of any pixel from `expected`.
double largest_error(const Image& image, const Rgba& expected) {
  return largest_difference(image, glm::dvec4(expected));
}

constexpr double float_rounding = 6e-8;  // an ulp of a float just below 1

class UnitRaytraceStack : public ::testing::TestWithParam<int> {};

TEST_P(UnitRaytraceStack, MatchesTheClosedFormInAnyOrder) {
  const int n = GetParam();
  const float alpha = 0.3f;
  for (const std::uint32_t shuffle : {0u, 7u, 8u}) {
    scene::Scene scene = stack(
        n, 5, 3, [&](int) { return Rgba(0, 0.25, 1, alpha); }, shuffle);
    scene.background = Vec3(1, 0.5, 0);
    const scene::Rendering rendering = trace(scene);
    const double t = std::pow(1 - double(alpha), n);
    EXPECT_LE(largest_error(rendering.image, Rgba(t, 0.25 * (1 - t) + 0.5 * t, 1 - t, 1 - t)),
              float_rounding);
    for (const std::uint32_t layers : rendering.layers.pixels)
      EXPECT_EQ(layers, static_cast<std::uint32_t>(n));
    EXPECT_EQ(rendering.stats.fragments, 15u * n);
    EXPECT_EQ(rendering.stats.max_layers, static_cast<std::uint32_t>(n));
  }
}

INSTANTIATE_TEST_SUITE_P(Layers, UnitRaytraceStack, ::testing::Values(1, 2, 10, 1000));

TEST(UnitRaytrace, OrderMattersAndIsRight) {
  // Red (α = 0.5) before green (α = 0.8) over white: 0.5 + 0.5·0.2, 0.5·0.8 + 0.1, 0.1.
  const auto color = [](int i) { return i == 0 ? Rgba(1, 0, 0, 0.5) : Rgba(0, 1, 0, 0.8f); };
  for (const std::uint32_t shuffle : {0u, 1u, 2u, 3u})
    EXPECT_LE(largest_error(trace(stack(2, 4, 4, color, shuffle)).image, Rgba(0.6, 0.5, 0.1, 0.9)),
              float_rounding);
}

TEST(UnitRaytrace, OpacityAtTheLimits) {
  for (const float alpha : {0.f, 1e-8f, 0.9999f, 1 - 1e-7f, 1.f}) {
    const auto color = [&](int) { return Rgba(0, 0, 0, alpha); };
    const double t = std::pow(1 - double(alpha), 3);
    EXPECT_LE(largest_error(trace(stack(3, 3, 3, color)).image, Rgba(t, t, t, 1 - t)),
              float_rounding)
        << alpha;
  }
}

TEST(UnitRaytrace, InterpenetratingPlanesChangeOrderWhereTheyMeet) {
  // z = x (red) and z = -x (blue), opaque: the nearer one shows, blue on the left, red on the
  // right.
  scene::Scene scene = orthographic_scene(8, 8);
  geometry::TriangleMesh red = full_layer(0, Rgba(1, 0, 0, 1)),
                         blue = full_layer(0, Rgba(0, 0, 1, 1));
  for (Vec3& x : red.positions) x.z = x.x;
  for (Vec3& x : blue.positions) x.z = -x.x;
  scene.objects = {{"red", red}, {"blue", blue}};
  const scene::Rendering rendering = trace(scene);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      EXPECT_NEAR(rendering.image.at(x, y).r, x < 4 ? 0 : 1, float_rounding);
      EXPECT_NEAR(rendering.image.at(x, y).b, x < 4 ? 1 : 0, float_rounding);
    }
}

TEST(UnitRaytrace, EqualDepthsAreOrderedByObject) {
  for (const bool red_first : {true, false}) {
    scene::Scene scene = orthographic_scene(3, 3);
    const Rgba red(1, 0, 0, 0.5), blue(0, 0, 1, 0.5);
    scene.objects = {{"", full_layer(0, red_first ? red : blue)},
                     {"", full_layer(0, red_first ? blue : red)}};
    const scene::Rendering rendering = trace(scene);
    EXPECT_EQ(rendering.stats.max_layers, 2u);
    EXPECT_LE(largest_error(rendering.image,
                            red_first ? Rgba(0.75, 0.25, 0.5, 0.75) : Rgba(0.5, 0.25, 0.75, 0.75)),
              float_rounding);
  }
}

TEST(UnitRaytrace, AnOpaqueObjectHidesWhatLiesBehindItWhateverItsAlpha) {
  const Rgba red(1, 0, 0, 0.5), green(0, 1, 0, 0.25f), blue(0, 0, 1, 0.5);
  scene::Scene scene = orthographic_scene(3, 3);
  scene.objects = {
      {"", full_layer(-1, blue)}, {"", full_layer(0, green)}, {"", full_layer(1, red)}};
  scene.objects[1].opaque = true;
  const scene::Rendering rendering = trace(scene);
  EXPECT_LE(largest_error(rendering.image, Rgba(0.5, 0.5, 0, 1)), 0);
  EXPECT_EQ(rendering.stats.max_layers, 2u);
}

TEST(UnitRaytrace, SamplesAreAveraged) {
  // A black opaque layer covers x < 1/16 of a picture of 3 × 3 pixels: of the middle pixel, 2/3
  // wide, from -1/3 to 1/3, the leftmost 5 of 8 columns of samples, which lie 1/12 apart.
  scene::Scene scene = orthographic_scene(3, 3);
  scene.samples.per_axis = 8;
  scene.objects = {{"", rectangle(-2, 1.0 / 16, -2, 2, 0, Rgba(0, 0, 0, 1))}};
  const scene::Rendering rendering = trace(scene);
  EXPECT_NEAR(rendering.image.at(1, 1).r, 3.0 / 8, float_rounding);
  EXPECT_NEAR(rendering.image.at(1, 1).a, 5.0 / 8, float_rounding);
  EXPECT_EQ(rendering.layers.at(1, 1), 1u);
  EXPECT_EQ(rendering.stats.fragments, 3u * 64u + 3u * 40u);
}

TEST(UnitRaytrace, AdaptiveSamplesMakeThePictureOfAsManyEverywhere) {
  // Shapes of one colour: a pixel that equals all its neighbours has no edge, so nothing is missed.
  scene::Scene scene;
  scene.width = 161;
  scene.height = 149;
  for (const float x : {-0.8f, 0.1f}) {
    geometry::TriangleMesh triangle;
    triangle.positions = {{x, -0.9, 0}, {x + 0.7, -0.7, 0.3}, {x + 0.2, 0.8, -0.2}};
    triangle.colors.assign(3, Rgba(0.2, 0.9, x + 1, 0.6f));
    triangle.triangles = {{0, 1, 2}};
    scene.objects.push_back({"", triangle});
  }
  const scene::Rendering adaptive = trace(scene, {{"adaptive", "6"}, {"contrast", "0"}});
  scene.samples.per_axis = 6;
  const scene::Rendering everywhere = trace(scene);
  EXPECT_EQ(adaptive.image.pixels, everywhere.image.pixels);
  EXPECT_EQ(adaptive.layers.pixels, everywhere.layers.pixels);
  EXPECT_LT(adaptive.stats.fragments, everywhere.stats.fragments / 2);
  EXPECT_THROW(trace(scene, {{"adaptive", "6"}}), InputError);
}

TEST(UnitRaytrace, StoppingKeepsItsBoundAndSkipsLayers) {
  const auto color = [](int i) { return Rgba(i % 2, 0, 1, 0.1f); };
  const scene::Scene scene = stack(500, 2, 2, color);
  const Rgba exact = trace(scene).image.at(0, 0);
  for (const double bound : {1e-1, 1e-3, 1e-6}) {
    const scene::Rendering stopped = trace(scene, {{"stop-below", std::to_string(bound)}});
    const double error = largest_error(stopped.image, exact);
    EXPECT_LE(error, bound);
    // 0.9^n < bound first holds for
    EXPECT_EQ(stopped.stats.max_layers, std::ceil(std::log(bound) / std::log1p(-double(0.1f))));
  }
}

TEST(UnitRaytrace, HeadlightIsTwoSidedCosine) {
  scene::Scene scene = orthographic_scene(3, 3);
  scene.lighting = scene::Lighting::headlight;
  for (const double sign : {1.0, -1.0}) {
    geometry::TriangleMesh layer = full_layer(0, Rgba(1, 1, 1, 1));
    layer.normals.assign(4, sign * glm::normalize(Vec3(1, 0, 1)));
    scene.objects = {{"", layer}};
    const float cosine = std::sqrt(0.5f);
    EXPECT_LE(largest_error(trace(scene).image, Rgba(cosine, cosine, cosine, 1)), float_rounding);
  }
}

// Phong 1975 with the light at the eye: 0.15 ambient, 0.85 diffuse, and 0.35 (2 c² - 1)^24 of
// white; at c² = 3/4 the highlight is 0.35 / 2^24, at c = 1 whole, beyond c² = 1/2 none; never
// above white.
TEST(UnitRaytrace, PhongAddsAmbientLightAndAHighlight) {
  scene::Scene scene = orthographic_scene(3, 3);
  scene.lighting = scene::Lighting::phong;
  const auto lit_at = [&](double cosine, float grey) {
    geometry::TriangleMesh layer = full_layer(0, Rgba(grey, grey, grey, 1));
    layer.normals.assign(4, Vec3(std::sqrt(1 - cosine * cosine), 0, cosine));
    scene.objects = {{"", layer}};
    return trace(scene).image.pixels[4].r;
  };
  EXPECT_NEAR(lit_at(1, 0.5f), 0.5 + 0.35, float_rounding);
  EXPECT_NEAR(lit_at(-1, 0.9f), 1, float_rounding);
  EXPECT_NEAR(lit_at(std::sqrt(0.875), 0.4f),
              0.4 * (0.15 + 0.85 * std::sqrt(0.875)) + 0.35 * std::pow(0.75, 24), float_rounding);
  EXPECT_NEAR(lit_at(0.5, 0.4f), 0.4 * (0.15 + 0.85 * 0.5), float_rounding);
  EXPECT_NEAR(lit_at(0, 0.4f), 0.4 * 0.15, float_rounding);
}

TEST(UnitRaytrace, PerspectiveInterpolationIsLinearOnTheSurface) {
  // A plane tilted away from the eye, coloured by its own y: at each pixel the colour equals the y
  // of the point that the ray meets, in closed form.
  scene::Scene scene;
  scene.width = scene.height = 33;
  scene.camera = {.eye = {0, 0, 2}, .target = {0, 0, 0}, .fov = 20};
  geometry::TriangleMesh mesh = full_layer(0, Rgba(0, 0, 0, 1));
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.colors[i].r = float(mesh.positions[i].y / 3 + 0.5);
    mesh.positions[i].z = -mesh.positions[i].y;
  }
  scene.objects = {{"", mesh}};
  const scene::Rendering rendering = trace(scene);
  const double half = std::tan(10 * std::numbers::pi / 180);
  for (int row = 0; row < 33; ++row) {
    // The ray y = s t, z = 2 - t meets z = -y at t = 2 / (1 - s).
    const double s = half * (1 - 2 * (row + 0.5) / 33), y = s * 2 / (1 - s);
    EXPECT_NEAR(rendering.image.at(5, row).r, y / 3 + 0.5, 2 * float_rounding);
  }
}

TEST(UnitRaytrace, RefusesASceneBehindTheCamera) {
  scene::Scene scene;
  scene.camera = {.eye = {0, 0, -5}, .target = {0, 0, -10}};
  scene.objects = {{"", full_layer(0, Rgba(1))}};
  EXPECT_THROW(trace(scene), InputError);
}

TEST(UnitRaytrace, NeedlesAndTrianglesWithoutAreaDoNoHarm) {
  scene::Scene scene = orthographic_scene(16, 16);
  geometry::TriangleMesh mesh = full_layer(0, Rgba(0, 0, 0, 0.5));
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.colors.insert(mesh.colors.end(), 3, Rgba(1, 0, 0, 1));
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  add({-1, 0, 1}, {1, 0, 1}, {0, 0, 1});                  // no area
  add({0.0625, -1, 1}, {0.0625, 1, 1}, {0.0625, 0, -1});  // edge-on, through pixel centres
  add({0, 0, 1}, {0, 0, 1}, {0, 0, 1});                   // one point
  scene.objects = {{"", mesh}};
  EXPECT_LE(largest_error(trace(scene).image, Rgba(0.5, 0.5, 0.5, 0.5)), float_rounding);
}

TEST(SlowRaytrace, TenThousandLayersStayWithinRounding) {
  const auto color = [](int i) { return Rgba(i % 2, 0, 0, 1e-3f); };
  const int n = 10000;
  scene::Scene scene = stack(n, 2, 2, color);
  scene.background = Vec3(0);
  const double alpha = double(1e-3f);
  // Odd layers are red: a geometric series of ratio (1 - α)², first term α (1 - α).
  const double t = std::pow(1 - alpha, n), red = (1 - alpha) * (1 - t) / (2 - alpha);
  EXPECT_LE(largest_error(trace(scene).image, Rgba(red, 0, 0, 1 - t)), float_rounding);
}

// Rays of the middle row and column have a direction with a component of exactly 0.
TEST(UnitRaytrace, RaysAlongAnAxisMeetEverythingOnce) {
  scene::Scene scene;
  scene.width = scene.height = 21;
  scene.objects = {{"sheet", full_layer(0, Rgba(1, 0, 0, 0.5))}};
  scene.camera.fov = 20;
  for (const std::uint32_t layers : trace(scene).layers.pixels) EXPECT_EQ(layers, 1u);
}

}  // namespace
}  // namespace pellucid::groundtruth
