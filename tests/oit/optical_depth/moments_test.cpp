// SPDX-License-Identifier: GPL-3.0-or-later
// The optical depth from moments, as the shaders find it: compiled as C++ from the same text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace glsl {

using namespace glm;
#include "oit/optical_depth/power_moments.glsl"
#include "oit/optical_depth/trigonometric_moments.glsl"

}  // namespace glsl

namespace pellucid::oit::test {
namespace {

struct Mass {
  double at, mass;
};

/// As sharp or as blurred as a test asks for; mass 1 in all.
std::vector<Mass> random_masses(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Mass> masses;
  double total = 0;
  for (int i = 0; i < n; ++i) {
    const double at = (i + 0.2 + 0.6 * unit(random)) / n, mass = 0.1 + unit(random);
    masses.push_back({at, mass});
    total += mass;
  }
  for (Mass& m : masses) m.mass /= total;
  return masses;
}

double mass_before(const std::vector<Mass>& masses, double at) {
  double sum = 0;
  for (const Mass& m : masses) sum += m.at < at ? m.mass : 0;
  return sum;
}

/// The shader's functions for n points and one more, over d in [0, 1].
struct PowerBasis {
  static constexpr double end = 1;
  static float in_front(const std::vector<Mass>& masses, int n, double d, double bias,
                        float overestimation) {
    // The moments of the bias: of the uniform distribution.
    float moments[9];
    for (int k = 0; k <= 8; ++k) {
      double sum = 0;
      for (const Mass& m : masses) sum += m.mass * std::pow(2 * m.at - 1, k);
      moments[k] = float((1 - bias) * sum + bias * (k % 2 ? 0 : 1.0 / (k + 1)));
    }
    return glsl::mass_in_front(glsl::recurrence_of(moments, n), n, float(2 * d - 1),
                               overestimation);
  }
};

struct TrigonometricBasis {
  static constexpr double range = 1.9 * std::numbers::pi;
  static float in_front(const std::vector<Mass>& masses, int n, double d, double bias,
                        float overestimation) {
    glsl::TrigonometricMoments moments;
    for (int k = 0; k <= 4; ++k) {
      glm::dvec2 sum(0);
      for (const Mass& m : masses)
        sum += m.mass * glm::dvec2(std::cos(k * range * m.at), std::sin(k * range * m.at));
      moments.b[k] = k ? (1 - bias) * sum : sum;
    }
    return glsl::mass_in_front_of_angle(moments, n, float(range * d), float(range), overestimation);
  }
};

template <class Basis>
class UnitMoments : public ::testing::Test {};
using Bases = ::testing::Types<PowerBasis, TrigonometricBasis>;
TYPED_TEST_SUITE(UnitMoments, Bases);

// As many points as 2 n real moments can tell: between them the mass in front is known exactly.
TYPED_TEST(UnitMoments, OfFewLayersTellTheMassInFront) {
  for (int n = 2; n <= 4; ++n)
    for (unsigned seed = 0; seed < 50; ++seed) {
      const std::vector<Mass> masses = random_masses(n, seed);
      for (int gap = 0; gap < n - 1; ++gap) {
        const double d = 0.5 * (masses[std::size_t(gap)].at + masses[std::size_t(gap) + 1].at);
        // A share 1e-6 of something else within half a gap, 0.05 to 0.2 for n = 4, whose 2 n-th
        // power the moments tell from nothing.
        EXPECT_NEAR(TypeParam::in_front(masses, n, d, 1e-6, 0), mass_before(masses, d), 0.02)
            << n << ' ' << seed << ' ' << gap;
      }
    }
}

// In front of d, at d and behind it is everything: behind is in front in the mirrored picture.
TYPED_TEST(UnitMoments, OfAMirroredDistributionTellTheMassBehind) {
  for (int n = 2; n <= 4; ++n)
    for (unsigned seed = 0; seed < 50; ++seed) {
      const std::vector<Mass> masses = random_masses(9, seed);
      std::vector<Mass> mirrored = masses;
      for (Mass& m : mirrored) m.at = 1 - m.at;
      for (double d = 0.05; d < 1; d += 0.1)
        // Roundings of 6e-8 over norms of 1e-4 and more.
        EXPECT_NEAR(
            TypeParam::in_front(masses, n, d, 0, 1) + TypeParam::in_front(mirrored, n, 1 - d, 0, 0),
            1, 1e-3)
            << n << ' ' << seed << ' ' << d;
    }
}

using Complexes = std::vector<std::complex<double>>;

Complexes solve(std::vector<Complexes> matrix, Complexes right) {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k)  // a positive definite matrix needs no pivots
    for (std::size_t i = k + 1; i < n; ++i) {
      const std::complex<double> factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < n; ++j) matrix[i][j] -= factor * matrix[k][j];
      right[i] -= factor * right[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= matrix[k][j] * right[j];
    right[k] /= matrix[k][k];
  }
  return right;
}

/// The canonical distribution by another road, in double: v(s) are n + 1 functions that the moments
/// are the products of, B their matrix, K(s, t) = v(s)* B^-1 v(t) the kernel.
class Kernel {
 public:
  using Functions = std::function<Complexes(double)>;
  Kernel(const std::vector<Mass>& masses, Functions v) : v_(std::move(v)) {
    const std::size_t n = v_(0).size();
    matrix_.assign(n, Complexes(n));
    for (const Mass& m : masses) {
      const Complexes at = v_(m.at);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) matrix_[i][j] += m.mass * at[i] * std::conj(at[j]);
    }
  }
  std::complex<double> operator()(double s, double t) const {
    const Complexes at = v_(s), solution = solve(matrix_, v_(t));
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += std::conj(at[i]) * solution[i];
    return sum;
  }
  double mass(double s) const { return 1 / (*this)(s, s).real(); }

 private:
  Functions v_;
  std::vector<Complexes> matrix_;
};

/// Where a function that changes its sign a few times between `from` and `to` does so.
std::vector<double> roots_of(const std::function<double(double)>& f, double from, double to) {
  std::vector<double> roots;
  constexpr int steps = 500;
  const auto at = [&](int i) { return from + (to - from) * i / steps; };
  for (int i = 0; i < steps; ++i) {
    double low = at(i), high = at(i + 1);
    if ((f(low) < 0) == (f(high) < 0)) continue;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      ((f(middle) < 0) == (f(low) < 0) ? low : high) = middle;
    }
    roots.push_back(low);
  }
  return roots;
}

TEST(UnitCanonicalMoments, OfPowersAreThoseOfTheHankelMatrix) {
  for (int n = 2; n <= 4; ++n)
    for (unsigned seed = 0; seed < 3; ++seed) {
      const std::vector<Mass> masses = random_masses(8, seed);
      const Kernel kernel(masses, [&](double d) {
        Complexes powers{1};
        for (int k = 1; k <= n; ++k) powers.push_back(powers.back() * (2 * d - 1));
        return powers;
      });
      for (double d = 0.03; d < 1; d += 0.11) {
        double mass = 0.25 * kernel.mass(d);
        // The line as the tangent of an angle; cos^n keeps the kernel finite at its ends.
        const auto f = [&](double a) {
          return kernel(std::tan(a), d).real() * std::pow(std::cos(a), n);
        };
        for (const double a : roots_of(f, -1.57, 1.57))
          if (std::tan(a) < d) mass += kernel.mass(std::tan(a));
        // Roundings of 6e-8 over norms of 1e-4 and more.
        EXPECT_NEAR(PowerBasis::in_front(masses, n, d, 0, 0.25f), mass, 1e-3) << n << ' ' << d;
      }
    }
}

TEST(UnitCanonicalMoments, OfAnglesAreThoseOfTheToeplitzMatrix) {
  const double range = TrigonometricBasis::range, turn = 2 * std::numbers::pi;
  for (int n = 2; n <= 4; ++n)
    for (unsigned seed = 0; seed < 3; ++seed) {
      const std::vector<Mass> masses = random_masses(8, seed);
      const Kernel kernel(masses, [&](double d) {
        Complexes waves;
        for (int k = 0; k <= n; ++k) waves.push_back(std::polar(1.0, k * range * d));
        return waves;
      });
      for (double d = 0.03; d < 1; d += 0.11) {
        double mass = 0.25 * kernel.mass(d);
        const auto f = [&](double psi) {
          return (std::polar(1.0, 0.5 * n * psi) * kernel(d + psi / range, d)).real();
        };
        for (const double psi : roots_of(f, 0, turn)) {
          const double angle = range * d + psi;
          const double share =
              angle > turn ? 1 : std::clamp((angle - range) / (turn - range), 0.0, 1.0);
          mass += share * kernel.mass(d + psi / range);
        }
        // Roundings of 6e-8 over norms of 1e-4 and more.
        EXPECT_NEAR(TrigonometricBasis::in_front(masses, n, d, 0, 0.25f), mass, 1e-3)
            << n << ' ' << d;
      }
    }
}

// Of the uniform distribution the points are those of Gauss and Legendre where z is one of them;
// and it is itself a distribution with its moments: its mass lies between the bounds of Chebyshev,
// Markov and Stieltjes.
TEST(UnitCanonicalMoments, OfPowersOfTheUniformDistributionAreGaussPoints) {
  EXPECT_NEAR(PowerBasis::in_front({}, 2, 0.5, 1, 0), 5 / 18.0, 1e-5);
  EXPECT_NEAR(PowerBasis::in_front({}, 2, 0.5, 1, 1), 13 / 18.0, 1e-5);
  // Five points: the middle one weighs 128 / 225 of 2.
  EXPECT_NEAR(PowerBasis::in_front({}, 4, 0.5, 1, 0), 0.5 - 32 / 225.0, 1e-5);
  EXPECT_NEAR(PowerBasis::in_front({}, 4, 0.5, 1, 1), 0.5 + 32 / 225.0, 1e-5);
  // Four points: +-0.3399810436 with the weight 0.6521451549 of 2.
  EXPECT_NEAR(PowerBasis::in_front({}, 3, 0.5 + 0.5 * 0.3399810436, 1, 0), 0.5, 1e-5);
  for (int n = 2; n <= 4; ++n)
    for (double d = 0.01; d < 1; d += 0.01) {
      EXPECT_LE(PowerBasis::in_front({}, n, d, 1, 0), d) << n;
      EXPECT_GE(PowerBasis::in_front({}, n, d, 1, 1), d) << n;
    }
}

// On the circle they are n + 1 points at equal distances.
TEST(UnitCanonicalMoments, OfAnglesOfTheUniformDistributionAreEquallySpaced) {
  const std::vector<Mass> any = {{0, 1}};  // that a bias of 1 replaces
  const double range = TrigonometricBasis::range, turn = 2 * std::numbers::pi;
  for (int n = 2; n <= 4; ++n)
    for (double d = 0.0; d < 1; d += 0.07) {
      double in_front = 0;
      for (int k = 1; k <= n; ++k) {
        const double angle = range * d + turn * k / (n + 1);
        in_front += angle > turn ? 1 : std::clamp((angle - range) / (turn - range), 0.0, 1.0);
      }
      // Near the turn a rounding of the angle is 2e-6 of the rest of it.
      EXPECT_NEAR(TrigonometricBasis::in_front(any, n, d, 1, 0), in_front / (n + 1), 1e-5) << n;
      EXPECT_NEAR(TrigonometricBasis::in_front(any, n, d, 1, 1), (in_front + 1) / (n + 1), 1e-5);
    }
}

// The moments of a single layer leave nothing to choose, and no digits but for the bias: within
// 0.1 of the layer some of it may be where z is, (1e-5)^(1/4) of the line for n = 2.
TYPED_TEST(UnitMoments, OfOneLayerTellBeforeFromBehind) {
  for (int n = 2; n <= 4; ++n)
    for (double at = 0.02; at < 1; at += 0.05)
      for (double d = 0.01; d < 1; d += 0.05)
        if (std::abs(d - at) > 0.1) {
          EXPECT_NEAR(TypeParam::in_front({{at, 1}}, n, d, 1e-5, 0), d > at ? 1 : 0, 0.02)
              << n << ' ' << at << ' ' << d;
        }
}

}  // namespace
}  // namespace pellucid::oit::test
