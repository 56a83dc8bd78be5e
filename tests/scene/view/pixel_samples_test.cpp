// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/pixel_samples.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace pellucid::scene {
namespace {

TEST(UnitPixelSamples, CellsHaveTheirCentres) {
  EXPECT_EQ(pixel_samples({}), std::vector{Vec2(0.5)});
  EXPECT_EQ(pixel_samples({.per_axis = 2}),
            (std::vector{Vec2(0.25, 0.25), Vec2(0.75, 0.25), Vec2(0.25, 0.75), Vec2(0.75, 0.75)}));
}

TEST(UnitPixelSamples, FramesAreHaltonsPoints) {
  const auto points = pixel_samples({.frames = 5});
  const double x[] = {1. / 2, 1. / 4, 3. / 4, 1. / 8, 5. / 8};
  const double y[] = {1. / 3, 2. / 3, 1. / 9, 4. / 9, 7. / 9};
  ASSERT_EQ(points.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(points[i].x, x[i], 1e-15);  // sums of a few rounded terms below 1
    EXPECT_NEAR(points[i].y, y[i], 1e-15);
  }
}

TEST(UnitPixelSamples, MoreFramesGoOnWhereFewerEnd) {
  const auto few = pixel_samples({.frames = 7}), many = pixel_samples({.frames = 64});
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

/// By how much the share of the samples left of x differs from x, at worst, over all x.
double discrepancy(int frames, int axis) {
  std::vector<double> places;
  for (const Vec2& sample : pixel_samples({.frames = frames})) places.push_back(sample[axis]);
  std::sort(places.begin(), places.end());
  double worst = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    worst = std::max({worst, std::abs(places[i] - double(i) / frames),
                      std::abs(places[i] - double(i + 1) / frames)});
  return worst;
}

// An edge along an axis: a pixel's share is off by the discrepancy, at most (log₂ n / 3 + 1) / n in
// base 2 and (log₃ n / 2 + 1) / n in base 3 (Niederreiter 1992, Theorem 3.6), which tends to 0.
TEST(PropertyPixelSamples, EdgesConvergeWithTheFrames) {
  for (const int frames : {4, 16, 64, 256, 1024}) {
    EXPECT_LE(discrepancy(frames, 0), (std::log2(frames) / 3 + 1) / frames) << frames;
    EXPECT_LE(discrepancy(frames, 1), (std::log(frames) / std::log(3) / 2 + 1) / frames) << frames;
  }
}

}  // namespace
}  // namespace pellucid::scene
