// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/frame_sequence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/metrics.h"
#include "core/error.h"
#include "tests/compare/methods/opacity_scenes.h"

namespace pellucid::compare {
namespace {

using namespace testing;

/// An unimportant sheet, line and discs before an important sheet, from before which a camera that
/// turns to the right moves them away.
scene::Scene turning(int frames, double degrees) {
  scene::Scene scene = orthographic_scene(24, 24);
  geometry::TriangleMesh front = rectangle(-0.3, 0.5, -1, -0.4, 1, Rgba(1, 0, 0, 0.8));
  geometry::TriangleMesh back = rectangle(-0.3, 0.9, -1, 1, -1, Rgba(0, 0, 1, 0.8));
  back.importance.assign(4, 1);
  scene::LineObject line;
  line.radius = 0.15;
  line.set.positions = {{-1, 0.6, 0.5}, {0, 0.6, 0.5}, {1, 0.6, 0.5}};
  line.set.colors.assign(3, Rgba(0, 1, 0, 0.8));
  line.set.offsets = {0, 3};
  scene::PointObject points;
  points.radius = 0.2;
  points.set.positions = {{-0.35, 0.1, 0.8}, {0.5, 0.1, 0.8}};
  points.set.colors.assign(2, Rgba(1, 1, 0, 0.8));
  scene.objects = {{"front", front}, {"line", line}, {"points", points}, {"back", back}};
  scene.energy = {.p = 1, .q = 20, .r = 5, .lambda = 1};
  scene.camera.up = Vec3(0, 1, 0);
  scene.camera_path = scene::orbit(scene.camera, degrees, frames);
  return scene;
}

std::vector<SequenceFrame> sequence(scene::Scene scene, std::string_view method,
                                    const RawOptions& options = {},
                                    const std::optional<MethodCall>& opacities = {},
                                    const std::optional<MethodCall>& reference = {}) {
  const scene::MethodRow& row = find_row("method", method, methods());
  std::vector<SequenceFrame> frames;
  render_sequence(
      scene, {&row, Parameters(row.name, row.parameters, options)}, opacities, {},
      [&](const SequenceFrame& frame) { frames.push_back(frame); }, reference);
  return frames;
}

MethodCall call_of(std::string_view name) {
  const scene::MethodRow& row = find_row("method", name, methods());
  return {&row, Parameters(row.name, row.parameters, {})};
}

constexpr const char* optimizing[] = {"fourier-opacity", "decoupled-lists"};

// What is remembered between frames is the stage's, whichever method composites.
TEST(AgreementFrameSequence, OpacitiesOfAStageOfItsOwnAreThoseOfTheMethod) {
  const RawOptions keep = {{"keep", "0.5"}};
  const auto whole = sequence(turning(3, 20), "decoupled-lists", keep);
  const auto staged =
      sequence(turning(3, 20), "linked-list", {}, parse_opacities("decoupled-lists:keep=0.5"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(largest_difference(whole[i].rendering.image, staged[i].rendering.image),
              float_composite);
    ASSERT_EQ(whole[i].opacity.has_value(), staged[i].opacity.has_value());
    if (whole[i].opacity) {
      EXPECT_EQ(whole[i].opacity->largest, staged[i].opacity->largest);
    }
  }
}

TEST(UnitFrameSequence, AStillCameraChangesNothing) {
  for (const char* method : optimizing)
    for (const char* keep : {"0", "0.5"}) {
      const auto frames = sequence(turning(3, 0), method, {{"keep", keep}});
      ASSERT_EQ(frames.size(), 3u);
      EXPECT_FALSE(frames[0].opacity);
      EXPECT_FALSE(frames[0].picture);
      for (std::size_t i = 1; i < 3; ++i) {
        EXPECT_EQ(frames[i].motion.degrees, 0);
        ASSERT_TRUE(frames[i].opacity) << method;
        // Sums of a series depend on the order in which fragments came.
        EXPECT_LT(frames[i].opacity->largest, 1e-4) << method;
        EXPECT_LT(*frames[i].picture, 1e-4) << method;
      }
    }
}

TEST(UnitFrameSequence, WithoutAPathThereIsNoFrame) {
  scene::Scene scene = turning(2, 10);
  scene.camera_path.clear();
  EXPECT_TRUE(sequence(scene, "linked-list").empty());
}

TEST(UnitFrameSequence, MethodsThatOptimizeNothingHaveNoOpacityChange) {
  const auto frames = sequence(turning(2, 20), "linked-list");
  EXPECT_FALSE(frames[1].opacity);
  EXPECT_GT(*frames[1].picture, 0.01);
}

TEST(UnitFrameSequence, WithoutAReferenceNothingIsSaidOfErrors) {
  EXPECT_FALSE(sequence(turning(2, 20), "linked-list")[1].error);
}

TEST(UnitFrameSequence, AMethodIsItsOwnReference) {
  const auto frames = sequence(turning(3, 20), "raytrace", {}, {}, call_of("raytrace"));
  EXPECT_FALSE(frames[0].error->flicker);
  for (const SequenceFrame& frame : frames) EXPECT_EQ(frame.error->metrics.linear.of("rmse"), 0);
  EXPECT_EQ(frames[2].error->flicker, 0);
}

// By its definition, from pictures that were made apart: rms of (t₁ - r₁) - (t₀ - r₀).
TEST(PropertyFrameSequence, FlickerIsTheChangeOfTheError) {
  const auto truth = sequence(turning(2, 20), "raytrace");
  const auto frames = sequence(turning(2, 20), "weighted-average", {}, {}, call_of("raytrace"));
  EXPECT_NEAR(*frames[1].error->metrics.linear.of("rmse"),
              rmse(truth[1].rendering.image, frames[1].rendering.image), 1e-6);
  double squares = 0;
  const std::size_t pixels = truth[0].rendering.image.pixels.size();
  const auto error = [&](std::size_t frame, std::size_t i, int c) {
    return double(frames[frame].rendering.image.pixels[i][c]) -
           double(truth[frame].rendering.image.pixels[i][c]);
  };
  for (std::size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c) squares += std::pow(error(1, i, c) - error(0, i, c), 2);
  const double flicker = std::sqrt(squares / (3 * double(pixels)));
  EXPECT_GT(flicker, 0.01);
  EXPECT_NEAR(*frames[1].error->flicker, flicker, 1e-6);  // differences of floats below 1
}

// Both composite the opacities that one stage found, so that only compositing differs.
TEST(UnitFrameSequence, TheReferenceCompositesTheSameOpacities) {
  const auto frames = sequence(turning(2, 20), "linked-list", {},
                               parse_opacities("decoupled-lists:keep=0.5"), call_of("raytrace"));
  for (const SequenceFrame& frame : frames)
    EXPECT_LT(*frame.error->metrics.linear.of("rmse"), 0.02);  // edges of a 24 x 24 picture
}

// The second frame shows keep · last + (1 - keep) · found: it differs from the last by 1 - keep of
// what it would.
TEST(PropertyFrameSequence, WhatIsKeptOfTheLastFrameScalesTheChange) {
  for (const char* method : optimizing) {
    const auto change = [&](const char* keep) {
      return *sequence(turning(2, 25), method, {{"keep", keep}})[1].opacity;
    };
    const Change whole = change("0"), half = change("0.5"), none = change("1");
    EXPECT_GT(whole.largest, 0.1) << method;
    // Opacities are floats below 1. Measured 3e-8, half an ulp; ten times that.
    EXPECT_NEAR(half.mean, 0.5 * whole.mean, 3e-7) << method;
    EXPECT_NEAR(half.largest, 0.5 * whole.largest, 3e-7) << method;
    EXPECT_LT(none.largest, 1e-6) << method;
  }
}

// Points are drawn with the opacities that were found for them, lines and meshes with those of
// vertices: of either kind the picture has to show what was kept. In the first frame each hides
// some of the important sheet, in the second none.
TEST(PropertyFrameSequence, ThePictureShowsWhatIsKept) {
  for (const char* method : optimizing)
    for (const std::size_t object : {0u, 1u, 2u}) {
      scene::Scene scene = turning(2, 25);
      scene.objects = {scene.objects[object], scene.objects.back()};
      const auto drawn = [&](const char* keep) {
        return sequence(scene, method, {{"keep", keep}})[1].rendering.image;
      };
      EXPECT_GT(largest_difference(drawn("0"), drawn("1")), 0.02) << method << ' ' << object;
    }
}

}  // namespace
}  // namespace pellucid::compare
