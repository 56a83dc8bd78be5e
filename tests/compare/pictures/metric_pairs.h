// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/raster.h"

namespace pellucid::testing {}

namespace pellucid::compare::testing {

using namespace pellucid::testing;

/// A colour value from a pixel's column, row and channel.
using Formula = std::function<double(std::int64_t x, std::int64_t y, std::int64_t c)>;

inline Image picture(int width, int height, const Formula& formula) {
  Image image(width, height, Rgba(1));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = float(formula(x, y, c));
  return image;
}

// The formulas of scripts/make-metric-expectations.py.

inline double hashed(std::int64_t x, std::int64_t y, std::int64_t c, std::int64_t seed) {
  auto h = std::uint32_t(x * 73856093 ^ y * 19349663 ^ c * 83492791 ^ seed * 2654435761);
  h = (h ^ (h >> 16)) * 0x45D9F3B;
  h = (h ^ (h >> 16)) * 0x45D9F3B;
  return (h ^ (h >> 16)) / 4294967296.0;
}

inline double gradient(std::int64_t x, std::int64_t y, std::int64_t c) {
  return double((3 * x + 5 * y + 40 * c) % 256) / 255.0;
}
inline double rings(std::int64_t x, std::int64_t y, std::int64_t c) {
  return double((x * x + y * y + 17 * c) % 301) / 300.0;
}
inline double noise(std::int64_t x, std::int64_t y, std::int64_t c) { return hashed(x, y, c, 1); }
inline double grainy(std::int64_t x, std::int64_t y, std::int64_t c) {
  return 0.9 * gradient(x, y, c) + 0.1 * noise(x, y, c);
}

struct FormulaPair {
  std::string name;
  Formula x, y;
};

/// In the order of the script.
inline std::vector<FormulaPair> formula_pairs() {
  return {
      {"gradient against itself with noise", gradient, grainy},
      {"odd sizes", rings, [](auto x, auto y, auto c) { return 0.5 * rings(x, y, c) + 0.25; }},
      {"one window", gradient, noise},
      {"narrow", rings, gradient},
      {"wide, more rows than a band", noise,
       [](auto x, auto y, auto c) { return 1.0 - noise(x, y, c); }},
      {"constants", [](auto, auto, auto) { return 0.25; }, [](auto, auto, auto) { return 0.75; }},
      {"nearly constant", [](auto, auto, auto) { return 0.5; },
       [](auto x, auto y, auto c) { return 0.5 + noise(x, y, c) / 1048576.0; }},
      {"tiny values", [](auto x, auto y, auto c) { return noise(x, y, c) / 65536.0; },
       [](auto x, auto y, auto c) { return hashed(x, y, c, 2) / 65536.0; }},
      {"HDR, to 64", [](auto x, auto y, auto c) { return 64.0 * rings(x, y, c); },
       [](auto x, auto y, auto c) { return 64.0 * grainy(x, y, c); }},
      {"HDR, bright with small differences",
       [](auto x, auto y, auto c) { return 1000.0 + noise(x, y, c); },
       [](auto x, auto y, auto c) { return 1000.0 + grainy(x, y, c); }},
      {"negative values", [](auto x, auto y, auto c) { return noise(x, y, c) - 0.5; },
       [](auto x, auto y, auto c) { return rings(x, y, c) - 0.5; }},
      {"equal", rings, rings}};
}

}  // namespace pellucid::compare::testing
