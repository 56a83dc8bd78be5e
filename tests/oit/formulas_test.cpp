// The formulas that the shaders run, compiled as C++ from the same text.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <random>

#include "scene/opacity_energy.h"

namespace glsl {

using namespace glm;
#include "oit/blended_weight.glsl"
#include "oit/fourier_series.glsl"
#include "oit/opacity_energy.glsl"
#include "oit/optical_depth.glsl"
#include "oit/optical_weight.glsl"
#include "oit/power_moments.glsl"

}  // namespace glsl

namespace pellucid::test {
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
  EXPECT_NEAR(series.integral(d), expected, 1e-5);
}

// 1 / bands is how fast a series nears a step away from it.
TEST(UnitFormulas, FourierSeriesNearsTheStep) {
  Series series;
  series.add(1, 0.5f);
  EXPECT_NEAR(series.integral(0.25f), 0, 1.0 / Series::bands);
  EXPECT_NEAR(series.integral(0.75f), 1, 1.0 / Series::bands);
  EXPECT_NEAR(series.integral(0.5f), 0.5, 1e-5);
}

// The numbers are Eqs. 7 to 10 of McGuire and Bavoil 2013 by hand at z = 20 and d = 0.5.
TEST(UnitFormulas, BlendedWeightsAreTheirEquations) {
  EXPECT_NEAR(glsl::blended_weight_7(20), 10 / (1e-5 + 16 + 1e-6), 1e-6);
  EXPECT_NEAR(glsl::blended_weight_8(20), 10 / (1e-5 + 8 + 1e-6), 1e-6);
  EXPECT_NEAR(glsl::blended_weight_9(20), 0.03 / (1e-5 + 1e-4), 1e-3);
  EXPECT_NEAR(glsl::blended_weight_10(0.5f), 375, 1e-3);
  EXPECT_FLOAT_EQ(glsl::blended_weight_10(1), 1e-2f);
  EXPECT_FLOAT_EQ(glsl::blended_weight_9(500), 1e-2f);
  EXPECT_FLOAT_EQ(glsl::blended_weight(0, 0.5f, 0.5f), 1);
  EXPECT_FLOAT_EQ(glsl::blended_weight(10, 0.5f, 0.5f), 187.5f);
}

/// Moments of masses at depths, mass 1 in all.
struct Moments {
  double b[7] = {};
  void add(double mass, double z) {
    for (int k = 0; k <= 6; ++k) b[k] += mass * std::pow(z, k);
  }
  glm::vec4 first() const { return glm::vec4(b[1], b[2], b[3], b[4]); }
  glm::vec2 more() const { return glm::vec2(b[5], b[6]); }
};

// Two layers have three moments that matter, three layers five: between the layers the mass in
// front is known exactly. A small mass everywhere, as the bias puts it there, keeps it regular.
TEST(UnitFormulas, MomentsOfFewLayersTellTheMassInFront) {
  Moments two, three;
  two.add(0.3, -0.5);
  two.add(0.7, 0.4);
  three.add(0.2, -0.6);
  three.add(0.5, 0.1);
  three.add(0.3, 0.7);
  for (const auto& [z, mass] : {std::pair(-0.9f, 0.0f), {0.0f, 0.3f}, {0.8f, 1.0f}}) {
    const glm::vec4 b = glm::mix(two.first(), glm::vec4(0, 0.375, 0, 0.375), 1e-4f);
    // The bias of 1e-4, over the squared distance to the nearest layer.
    EXPECT_NEAR(glsl::mass_in_front_4(b, z, 0), mass, 5e-3) << z;
  }
  for (const auto& [z, mass] :
       {std::pair(-0.9f, 0.0f), {-0.3f, 0.2f}, {0.4f, 0.7f}, {0.95f, 1.0f}}) {
    const glm::vec4 b = glm::mix(three.first(), glm::vec4(0, 0.48, 0, 0.451), 1e-4f);
    const glm::vec2 c = glm::mix(three.more(), glm::vec2(0, 0.45), 1e-4f);
    EXPECT_NEAR(glsl::mass_in_front_6(b, c, z, 0), mass, 1e-2) << z;
  }
}

// The mass at z is 1 / (v B^-1 v), v = (1, z, z^2, …), B the Hankel matrix: here by inverting it.
// And what lies in front of z, at z and behind it, which is in front of -z for the mirrored
// distribution, is everything.
TEST(UnitFormulas, CanonicalMassesAreThoseOfTheHankelMatrix) {
  Moments m;
  for (const auto& [mass, z] :
       {std::pair(0.3, -0.8), {0.1, -0.3}, {0.2, 0.0}, {0.25, 0.35}, {0.15, 0.9}})
    m.add(mass, z);
  const glm::dmat3 three(m.b[0], m.b[1], m.b[2], m.b[1], m.b[2], m.b[3], m.b[2], m.b[3], m.b[4]);
  const glm::dmat4 four(m.b[0], m.b[1], m.b[2], m.b[3], m.b[1], m.b[2], m.b[3], m.b[4], m.b[2],
                        m.b[3], m.b[4], m.b[5], m.b[3], m.b[4], m.b[5], m.b[6]);
  const glm::vec4 b = m.first(), mirrored = b * glm::vec4(-1, 1, -1, 1);
  const glm::vec2 c = m.more(), more_mirrored = c * glm::vec2(-1, 1);
  for (float z = -0.95f; z < 1; z += 0.1f) {
    const glm::dvec3 v3(1, z, z * z);
    const glm::dvec4 v4(1, z, z * z, z * z * z);
    const double at3 = 1 / glm::dot(v3, glm::inverse(three) * v3);
    const double at4 = 1 / glm::dot(v4, glm::inverse(four) * v4);
    // Roundings of 6e-8 over norms of about 1e-3.
    EXPECT_NEAR(glsl::mass_in_front_4(b, z, 1) - glsl::mass_in_front_4(b, z, 0), at3, 1e-4) << z;
    EXPECT_NEAR(glsl::mass_in_front_6(b, c, z, 1) - glsl::mass_in_front_6(b, c, z, 0), at4, 1e-3)
        << z;
    EXPECT_NEAR(glsl::mass_in_front_4(b, z, 1) + glsl::mass_in_front_4(mirrored, -z, 0), 1, 1e-3)
        << z;
    EXPECT_NEAR(
        glsl::mass_in_front_6(b, c, z, 1) + glsl::mass_in_front_6(mirrored, more_mirrored, -z, 0),
        1, 1e-2)
        << z;
  }
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

TEST(UnitFormulas, TheOptimalOpacityIsThatInDouble) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const glm::vec4 w(0.1f + unit(random), 100 * unit(random), 100 * unit(random),
                      i % 3 ? 4 * unit(random) : 0.0f);
    const float g = i % 5 ? unit(random) : 1.0f;
    const float front = 5 * unit(random) - 1, behind = 5 * unit(random) - 1;
    // A dozen roundings; the power has some 2 lambda of 1 - g more.
    EXPECT_NEAR(glsl::optimal_opacity(w, g, front, behind),
                optimal_opacity({w.x, w.y, w.z, w.w}, g, front, behind), 2e-6)
        << g << ' ' << front << ' ' << behind;
  }
}

}  // namespace
}  // namespace pellucid::test
