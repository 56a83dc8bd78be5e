// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace pellucid::testing {}

namespace pellucid::compare::testing {

using namespace pellucid::testing;

/// A Noise is a distribution of times around 1 with a median that is known.
struct Noise {
  std::string name;
  double median;
  std::function<double(std::mt19937_64&)> draw;
};

/// Times are skewed: nothing makes a picture faster, and much makes it slower now and then.
inline std::vector<Noise> skewed_noises() {
  const auto lognormal = [](double sigma) {
    return [sigma](std::mt19937_64& random) {
      return std::lognormal_distribution<double>(0, sigma)(random);
    };
  };
  const auto delayed = [](double mean) {
    return [mean](std::mt19937_64& random) {
      return 1 + std::exponential_distribution<double>(1 / mean)(random);
    };
  };
  return {{"log-normal, 3 %", 1, lognormal(0.03)},
          {"log-normal, 10 %", 1, lognormal(0.1)},
          {"log-normal, 50 %", 1, lognormal(0.5)},
          {"delays of 10 %", 1 + 0.1 * std::numbers::ln2, delayed(0.1)},
          {"delays of 50 %", 1 + 0.5 * std::numbers::ln2, delayed(0.5)}};
}

}  // namespace pellucid::compare::testing
