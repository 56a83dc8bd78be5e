// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas that the shaders run, compiled as C++ from the same text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "scene/opacity_energy.h"

namespace glsl {

using namespace glm;
#include "oit/methods/weighted/blended_weight.glsl"
#include "oit/opacity/opacity_energy.glsl"
#include "oit/optical_depth/fourier_series.glsl"
#include "oit/optical_depth/nearness.glsl"
#include "oit/optical_depth/optical_depth.glsl"
#include "oit/optical_depth/optical_weight.glsl"

}  // namespace glsl

namespace pellucid::oit::test {
namespace {

TEST(UnitFormulas, OpticalDepthKeepsTheDigitsOfSmallOpacities) {
  for (const float alpha : {0.0f, 1e-30f, 1e-8f, 1e-4f, 0.0099f, 0.01f, 0.3f, 0.9999f}) {
    const double exact = -std::log1p(-double(alpha));
    // 1 - alpha and its logarithm round once each: near 0.01 that is 6e-8 / 0.01.
    EXPECT_NEAR(glsl::optical_depth(alpha), exact, 1e-5 * exact) << alpha;
    EXPECT_NEAR(glsl::opacity(float(exact)), alpha, 1e-5 * alpha) << alpha;
  }
}

/// A series of 15 bands, summed as the shaders do.
struct Series {
  static constexpr int bands = 15;
  glm::vec2 coefficients[bands + 1] = {};

  void add(float f, float d) {
    glm::vec2 wave(1, 0);
    for (glm::vec2& c : coefficients) {
      c += glsl::fourier_project(f, wave);
      wave = glsl::add_angles(wave, glsl::first_wave(d));
    }
  }
  float integral(float d) const {
    float sum = 0;
    glm::vec2 wave(1, 0);
    for (int k = 0; k <= bands; ++k) {
      sum += glsl::fourier_integral(k, coefficients[k], d, wave);
      wave = glsl::add_angles(wave, glsl::first_wave(d));
    }
    return sum;
  }
};

TEST(UnitFormulas, TheFirstWaveIsCosineAndSine) {
  for (int i = 0; i <= 1000; ++i) {
    const float d = float(i) / 1000;
    // A few roundings, and 6e-8 of the power series cut off.
    EXPECT_NEAR(glsl::first_wave(d).x, std::cos(2 * M_PI * double(d)), 5e-7) << d;
    EXPECT_NEAR(glsl::first_wave(d).y, std::sin(2 * M_PI * double(d)), 5e-7) << d;
  }
}

TEST(UnitFormulas, FourierSeriesIsExactAtItsEnds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  Series series;
  double total = 0;
  for (int i = 0; i < 50; ++i) {
    const float f = unit(random);
    series.add(f, unit(random));
    total += f;
  }
  // Eq. 6; the sines at 2 pi k are about 15 roundings of the recurrence away from 0.
  EXPECT_NEAR(series.integral(0), 0, 1e-6);
  EXPECT_NEAR(series.integral(1), total, 1e-4);
}

TEST(UnitFormulas, FourierSeriesIsItsSum) {
  const float at = 0.3f, d = 0.65f;
  Series series;
  series.add(2, at);
  double expected = 2 * double(d);  // Eq. 5 with the coefficients of Eq. 8, in double
  for (int k = 1; k <= Series::bands; ++k) {
    const double w = 2 * M_PI * k;
    expected +=
        4 / w * (std::cos(w * at) * std::sin(w * d) + std::sin(w * at) * (1 - std::cos(w * d)));
  }
  // Each band rounds a coefficient of at most 2 and a wave whose angle, up to 2π times the band, is
  // off by 6e-8 of itself: over π k each, some 2e-7 a band.
  EXPECT_NEAR(series.integral(d), expected, 3e-6);
}

// 1 / bands is how fast a series nears a step away from it.
TEST(UnitFormulas, FourierSeriesNearsTheStep) {
  Series series;
  series.add(1, 0.5f);
  EXPECT_NEAR(series.integral(0.25f), 0, 1.0 / Series::bands);
  EXPECT_NEAR(series.integral(0.75f), 1, 1.0 / Series::bands);
  // Likewise.
  EXPECT_NEAR(series.integral(0.5f), 0.5, 3e-6);
}

// The numbers are Eqs. 7 to 10 of McGuire and Bavoil 2013 by hand at z = 20 and d = 0.5.
TEST(UnitFormulas, BlendedWeightsAreTheirEquations) {
  EXPECT_NEAR(glsl::blended_weight_7(20), 10 / (1e-5 + 16 + 1e-6), 1e-6);
  EXPECT_NEAR(glsl::blended_weight_8(20), 10 / (1e-5 + 8 + 1e-6), 1e-6);
  // A float of 273 or 375 has an ulp of 3e-5; a power and a quotient take three at most.
  EXPECT_NEAR(glsl::blended_weight_9(20), 0.03 / (1e-5 + 1e-4), 1e-4);
  EXPECT_NEAR(glsl::blended_weight_10(0.5f), 375, 1e-4);
  EXPECT_FLOAT_EQ(glsl::blended_weight_10(1), 1e-2f);
  EXPECT_FLOAT_EQ(glsl::blended_weight_9(500), 1e-2f);
  EXPECT_FLOAT_EQ(glsl::blended_weight(0, 0.5f, 0.5f), 1);
  EXPECT_FLOAT_EQ(glsl::blended_weight(10, 0.5f, 0.5f), 187.5f);
}

// The theorem of the additional material, section 3: with the exact optical depth the weights of
// Eq. 15 sum to 1 - exp(-tau(1)), so that normalizing (Eq. 19) changes nothing.
TEST(UnitFormulas, WeightsOfTheExactOpticalDepthSumToTheOpacity) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int n = 1; n <= 64; n *= 2) {
    double tau = 0, weights = 0;
    for (int i = 0; i < n; ++i) {
      const float alpha = unit(random) * 0.9f;
      tau += glsl::optical_depth(alpha);
      weights += glsl::optical_weight(alpha, float(tau));
    }
    // 64 weights below 1 in float.
    EXPECT_NEAR(weights, 1 - std::exp(-tau), 1e-6) << n;
  }
}

// A sum of n terms is at most n times the largest one. The digits of a float of some hundreds are
// some 1e-5 of an exponent of 226.
TEST(UnitFormulas, TheNearestDepthIsFoundFromASumAndNeverFarther) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  for (const int n : {1, 2, 30, 1000})
    for (const float nearest : {0.0f, 0.25f, 0.9f, 1.0f}) {
      float sum = glsl::nearness(nearest);
      for (int i = 1; i < n; ++i) sum += glsl::nearness(nearest + (1 - nearest) * unit(random));
      EXPECT_LE(glsl::nearest_depth(sum), nearest + 1e-6f) << n;
      EXPECT_GE(glsl::nearest_depth(sum), nearest - float(std::log2(n)) / 226 - 1e-6f) << n;
    }
  EXPECT_EQ(glsl::nearest_depth(1e8f * glsl::nearness(0)), 0);
}

TEST(UnitFormulas, TheOptimalOpacityIsThatInDouble) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const glm::vec4 w(0.1f + unit(random), 100 * unit(random), 100 * unit(random),
                      i % 3 ? 4 * unit(random) : 0.0f);
    const float g = i % 5 ? unit(random) : 1.0f;
    const float front = 5 * unit(random) - 1, behind = 5 * unit(random) - 1;
    // A dozen roundings; the power has some 2 lambda of 1 - g more.
    EXPECT_NEAR(glsl::optimal_opacity(w, 1 - g, front, behind),
                scene::optimal_opacity({w.x, w.y, w.z, w.w}, g, front, behind), 2e-6)
        << g << ' ' << front << ' ' << behind;
  }
  EXPECT_EQ(glsl::optimal_opacity({1, 1, 1, 0.3f}, -1.2e-7f, 5, 5), 1);
}

}  // namespace
}  // namespace pellucid::oit::test
