// SPDX-License-Identifier: GPL-3.0-or-later
// The progressive tree over whole pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "fields/make_field.h"
#include "tests/oit/oit_pictures.h"

namespace pellucid::oit {
namespace {

using namespace testing;

/// The square that a uniform flow along x sweeps from a segment along y, in [-1/2, 1/2]^2 at z. Its
/// mesh covers less than the lines do, so that a picture tells which of them was drawn.
scene::SceneObject swept_square(double z, const Vec3& color, double opacity) {
  scene::SceneObject object = sheet(z, Rgba(color, opacity));
  for (Vec3& x : object.mesh().positions) x = Vec3(1e-3 * x.x, 1e-3 * x.y, x.z);
  scene::FlowSource source;
  source.field = fields::make_field("formula:u=1,v=0,w=0");
  source.seed = integrators::segment_seed(Vec3(-0.5, -0.5, z), Vec3(-0.5, 0.5, z));
  source.duration = 1;
  source.appearance.color = color;
  source.appearance.opacity = opacity;
  object.source = source;
  return object;
}

/// Squares from front to back at z = 1/2 … -1/2 in a picture of 32 × 32 pixels of 1/16.
scene::Scene squares(const std::vector<Rgba>& front_to_back) {
  scene::Scene scene = empty_scene(32, 32);
  for (std::size_t i = 0; i < front_to_back.size(); ++i)
    scene.objects.push_back(swept_square(0.5 - double(i) / double(front_to_back.size()),
                                         Vec3(front_to_back[i]), front_to_back[i].a));
  return scene;
}

const RawOptions few_lines = {{"lines", "400"}, {"lines-per-frame", "80"}};

TEST(AgreementTree, MeshesAreTheExactLists) {
  const std::vector<Rgba> layers = random_layers(300, 0.1f, 21);
  const scene::Scene scene = stack(5, 3, layers);
  const scene::Rendering tree = render(method("tree"), scene, {}, true);
  // 300 layers in float: √300 of five roundings of 6e-8 each.
  EXPECT_LE(largest_difference(tree.image, composite(layers, scene.background)), 5e-6);
  EXPECT_EQ(tree.stats.max_layers, 300u);
  EXPECT_EQ(tree.stats.fragments, 300u * 15);
}

// Shuffled objects, a pixel's layers at equal depths among them.
TEST(AgreementTree, OrderOfMeshesChangesNothing) {
  scene::Scene scene = stack(9, 7, random_layers(60, 0.8f, 22));
  const Image before = render(method("tree"), scene).image;
  std::mt19937 random(23);
  std::shuffle(scene.objects.begin(), scene.objects.end(), random);
  EXPECT_EQ(largest_difference(render(method("tree"), scene).image, before), 0);
}

TEST(UnitTree, LinesTileTheSurface) {
  const std::vector<Rgba> layers = {{0.9f, 0.1f, 0.2f, 0.4f}, {0.1f, 0.8f, 0.3f, 0.5f}};
  const scene::Scene scene = squares(layers);
  const scene::Rendering tree = render(method("tree"), scene, few_lines, true);
  const glm::dvec4 inside = composite(layers, scene.background);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      // Lines reach half a pixel past the square's edges.
      const int distance = std::max(std::abs(2 * x - 31), std::abs(2 * y - 31));
      if (distance < 15) {
        EXPECT_EQ(tree.layers.at(x, y), 2u) << x << ' ' << y;
        // Two layers, each the mean of some 25 equal fragments of its lines.
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(tree.image.at(x, y)[c], inside[c], float_composite);
      } else if (distance > 17) {
        EXPECT_EQ(tree.layers.at(x, y), 0u) << x << ' ' << y;
      }
    }
}

// One layer of the mean colour and the mean opacity: equal numbers of lines on both squares.
TEST(UnitTree, EpsilonInfiniteIsOneLayer) {
  const scene::Scene scene = squares({{1, 0, 0, 0.4f}, {0, 1, 0, 0.6f}});
  RawOptions options = few_lines;
  options["epsilon2"] = "inf";
  const scene::Rendering tree = render(method("tree"), scene, options, true);
  EXPECT_EQ(tree.stats.max_layers, 1u);
  const glm::dvec4 expected = composite({{0.5f, 0.5f, 0, 0.5f}}, scene.background);
  // One layer, the mean of some 50 fragments of two kinds.
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(tree.image.at(16, 16)[c], expected[c], float_composite);
}

// Every fragment is a layer: so many lines of opacity 0.01 as cover a pixel's centre.
TEST(UnitTree, EpsilonZeroKeepsEveryFragment) {
  const scene::Scene scene = squares({{1, 0, 0, 0.01f}});
  RawOptions options = few_lines;
  options["epsilon2"] = "0";
  const scene::Rendering tree = render(method("tree"), scene, options, true);
  std::uint64_t layers = 0;
  for (const std::uint32_t n : tree.layers.pixels) layers += n;
  EXPECT_EQ(layers, tree.stats.fragments);
  // 400 lines over 16 pixels.
  EXPECT_NEAR(tree.layers.at(16, 16), 25, 2);
  EXPECT_NEAR(tree.image.at(16, 16).a, 1 - std::pow(0.99, tree.layers.at(16, 16)), float_composite);
}

/// n lines along x that cover the picture at z = ±noise around each of the layers' z.
scene::Scene sampled_by_lines(const std::vector<Rgba>& front_to_back, int n, double noise) {
  scene::Scene scene = empty_scene(6, 5);
  std::mt19937 random(24);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t i = 0; i < front_to_back.size(); ++i) {
    const double z = 1 - 2 * double(i) / double(front_to_back.size());
    geometry::LineSet set;
    for (int k = 0; k < n; ++k) {
      const double at = z + noise * unit(random);
      set.positions.insert(set.positions.end(), {Vec3(-50, 0, at), Vec3(50, 0, at)});
      set.colors.insert(set.colors.end(), 2, front_to_back[i]);
      set.offsets.push_back(set.positions.size());
    }
    scene.objects.push_back({"lines", scene::LineObject{std::move(set), 50}});
  }
  return scene;
}

// Any number of lines on a surface are one layer of it, where lists have as many as there are
// lines.
TEST(UnitTree, LinesOfTheSceneAreSamplesOfSurfaces) {
  const std::vector<Rgba> layers = {{0.9f, 0.1f, 0.2f, 0.4f}, {0.1f, 0.8f, 0.3f, 0.5f}};
  const scene::Scene scene = sampled_by_lines(layers, 90, 1e-4);
  const glm::dvec4 exact = composite(layers, scene.background);
  for (const char* per_frame : {"7", "1000"}) {
    const scene::Rendering tree =
        render(method("tree"), scene, {{"lines-per-frame", per_frame}}, true);
    EXPECT_LE(largest_difference(tree.image, exact), float_composite);
    EXPECT_EQ(tree.stats.max_layers, 2u);
    EXPECT_EQ(tree.stats.fragments, 2u * 90 * 30);
    std::uint64_t lines = 0;
    for (const scene::FrameStats& frame : tree.stats.frames) lines += frame.lines;
    EXPECT_EQ(lines, 180u);
  }
  EXPECT_GT(largest_difference(render(method("linked-list"), scene).image, exact), 0.2);
  const RawOptions integrated = {{"sampled", "integrated"}};
  EXPECT_EQ(render(method("tree"), scene, integrated, true).stats.max_layers, 180u);
}

// Room is made for layers, not for the fragments that are merged into them.
TEST(UnitTree, MemoryGrowsWithTheLayersNotWithTheFragments) {
  const scene::Scene scene =
      sampled_by_lines({{0.9f, 0.1f, 0.2f, 0.4f}, {0.1f, 0.8f, 0.3f, 0.5f}}, 900, 1e-4);
  const auto bytes_of_layers = [&](const char* epsilon2) {
    const scene::RenderStats stats =
        render(method("tree"), scene, {{"epsilon2", epsilon2}}, true).stats;
    EXPECT_EQ(stats.fragments, 2u * 900 * 30);
    for (const scene::NamedBytes& part : stats.bytes)
      if (part.name == "layers") return std::pair(part.bytes, stats.stored);
    return std::pair(std::uint64_t(0), stats.stored);
  };
  for (const char* epsilon2 : {"1e-6", "0"}) {
    const auto [bytes, layers] = bytes_of_layers(epsilon2);
    EXPECT_EQ(layers, epsilon2[0] == '1' ? 60u : 54000u);
    EXPECT_GE(bytes, 40 * layers);
    // A quarter more and 256, and layer 0.
    EXPECT_LE(bytes, 40 * (layers + layers / 4 + 257));
  }
}

TEST(UnitTree, MeshesAreSamplesWhereToldSo) {
  const Rgba color(0.9f, 0.1f, 0.2f, 0.4f);
  scene::Scene scene = empty_scene(3, 3);
  for (const double z : {1., -1., 0., 1e-4, 2e-4}) scene.objects.push_back(sheet(z, color));
  EXPECT_EQ(render(method("tree"), scene, {}, true).stats.max_layers, 5u);
  EXPECT_EQ(render(method("tree"), scene, {{"sampled", "all"}}, true).stats.max_layers, 3u);
}

// Of three sheets the middle one is within ε of both others. The last drawn is the first in a
// pixel's list and so the root of Algorithm 1's tree, which the middle one meets first.
TEST(UnitTree, TheRootTakesWhatIsWithinReachOfIt) {
  const Rgba red(1, 0, 0, 0.5f), green(0, 1, 0, 0.5f), blue(0, 0, 1, 0.5f);
  for (const bool front_is_root : {false, true})
    for (const double middle : {-0.04, -0.01, 0., 0.02, 0.036}) {
      scene::Scene scene = empty_scene(3, 3);
      scene.background = Vec3(0);
      scene.objects = {sheet(middle, blue), sheet(0.5, red), sheet(-0.4, green)};
      if (front_is_root) std::swap(scene.objects[1], scene.objects[2]);
      const Rgba both = front_is_root ? Rgba(0.5f, 0, 0.5f, 0.5f) : Rgba(0, 0.5f, 0.5f, 0.5f);
      const Image image = render(method("tree"), scene,
                                 {{"epsilon2", "0.64"}, {"merge", "first"}, {"sampled", "all"}})
                              .image;
      const auto expected = front_is_root ? composite({both, green}, scene.background)
                                          : composite({red, both}, scene.background);
      EXPECT_LE(largest_difference(image, expected), float_composite) << middle;
    }
}

// 4100 sorted sheets: a path that Algorithm 1 makes, and no loop of llvmpipe ends.
TEST(UnitTree, APathBeyondItsBoundIsAnError) {
  const scene::Scene scene = stack(1, 1, random_layers(4100, 1e-3f, 25));
  const RawOptions options{{"epsilon2", "0"}, {"merge", "first"}, {"sampled", "all"}};
  try {
    render(method("tree"), scene, options);
    ADD_FAILURE() << "drawn";
  } catch (const WorkError& error) {
    EXPECT_NE(std::string(error.what()).find("merge=nearest"), std::string::npos) << error.what();
  }
}

// Two layers 0.01 apart of a scene of depth 2: ε² of view depth is 4 times that of d.
TEST(UnitTree, EpsilonIsInViewDepthUnlessItIsSaidToBeInD) {
  scene::Scene scene = sampled_by_lines({{1, 0, 0, 0.4f}}, 1, 0);
  for (const double z : {0.01, -1.}) {
    scene::Scene other = sampled_by_lines({{1, 0, 0, 0.4f}}, 1, 0);
    for (Vec3& x : other.objects[0].vertices().positions) x.z = z;
    scene.objects.push_back(other.objects[0]);
  }
  for (Vec3& x : scene.objects[0].vertices().positions) x.z = 0;
  scene.objects.push_back(sheet(1, {1, 1, 1, 0.1f}));
  const auto layers = [&](const char* epsilon2, const char* unit) {
    return render(method("tree"), scene, {{"epsilon2", epsilon2}, {"unit", unit}}, true)
        .stats.max_layers;
  };
  EXPECT_EQ(layers("0.9e-4", "view"), 4u);
  EXPECT_EQ(layers("1.1e-4", "view"), 3u);
  EXPECT_EQ(layers("0.9e-4", "normalized"), 3u);
  EXPECT_EQ(layers("0.2e-4", "normalized"), 4u);
}

// The same scene in kilometres and in millimetres.
TEST(PropertyTree, DefaultEpsilonFollowsTheScale) {
  scene::Scene scene = sampled_by_lines({{1, 0, 0, 0.4f}, {0, 1, 0, 0.3f}}, 20, 1e-4);
  for (const double scale : {1., 1e-6, 1e9}) {
    scene::Scene scaled = scene;
    scaled.camera.eye *= scale;
    scaled.camera.target *= scale;
    scaled.camera.height *= scale;
    for (scene::SceneObject& object : scaled.objects) {
      for (Vec3& x : object.vertices().positions) x *= scale;
      std::get<scene::LineObject>(object.shape).radius *= scale;
    }
    EXPECT_EQ(render(method("tree"), scaled, {}, true).stats.max_layers, 2u) << scale;
  }
}

TEST(UnitTree, FramesAreRecorded) {
  const scene::Scene scene = squares({{1, 0, 0, 0.5f}});
  const auto frames = render(method("tree"), scene, few_lines).stats.frames;
  ASSERT_EQ(frames.size(), 5u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].lines, 80u);
    EXPECT_GT(frames[i].bytes, 0u);
    if (i == 0) continue;
    EXPECT_GT(frames[i].fragments, frames[i - 1].fragments);
    EXPECT_GE(frames[i].layers, frames[i - 1].layers);
    EXPECT_LT(frames[i].change, frames[0].change);
  }
}

TEST(UnitTree, EndsAtTheFirstBudgetReached) {
  const scene::Scene scene = squares({{1, 0, 0, 0.5f}});
  const auto count = [&](std::string_view key, std::string_view value) {
    RawOptions options = few_lines;
    options[std::string(key)] = value;
    return render(method("tree"), scene, options).stats.frames.size();
  };
  EXPECT_EQ(count("frames", "3"), 3u);
  EXPECT_EQ(count("seconds", "0"), 1u);
  EXPECT_EQ(count("change", "1"), 1u);
  // 80 lines fill 16 pixels: the second frame changes next to nothing.
  EXPECT_EQ(count("change", "0.05"), 2u);
  EXPECT_EQ(count("lines", "81"), 2u);
}

}  // namespace
}  // namespace pellucid::oit
