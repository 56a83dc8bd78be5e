// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compare/pictures/mask.h"
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

inline Image grey(int width, int height, float value) { return Image(width, height, Rgba(value)); }

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

inline Mask mask_by_hash(int width, int height) {
  Mask mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) mask.at(x, y) = hashed(x / 3, y / 3, 0, 7) < 0.3;
  return mask;
}

/// 0 to 3 layers, in blocks, so that two seeds agree now and then.
inline CountImage layers_by_hash(int width, int height, std::int64_t seed) {
  CountImage layers(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      layers.at(x, y) = std::uint32_t(std::floor(4 * hashed(x / 4, y / 4, 0, seed)));
  return layers;
}

/// Those of five scales.
inline std::vector<FormulaPair> scaled_pairs() {
  return {{"the least size", gradient, grainy},
          {"odd sizes at every scale", rings,
           [](auto x, auto y, auto c) { return 0.5 * rings(x, y, c) + 0.25; }},
          {"wide", grainy, gradient},
          {"each other's negative", noise,
           [](auto x, auto y, auto c) { return 1.0 - noise(x, y, c); }}};
}

// The formulas of scripts/make-flip-expectations.py.

inline double waves(std::int64_t x, std::int64_t y, std::int64_t c) {
  return 0.5 + 0.4 * std::sin(0.05 * double(x) + 0.03 * double(y) + 2.0 * double(c));
}

/// A picture of one primary colour.
inline Formula primary(std::int64_t channel) {
  return [channel](auto, auto, auto c) { return c == channel ? 1.0 : 0.0; };
}

inline Formula constant(double value) {
  return [value](auto, auto, auto) { return value; };
}

/// In the order of the script.
inline std::vector<FormulaPair> flip_pairs() {
  const auto lines = [](std::int64_t at) {
    return [at](auto x, auto, auto) { return 0.1 + 0.9 * double(x % 16 == at); };
  };
  return {{"gradient against itself with noise", gradient, grainy},
          {"odd sizes", rings, [](auto x, auto y, auto c) { return 0.5 * rings(x, y, c) + 0.25; }},
          {"smaller than the filters", gradient, noise},
          {"one pixel", constant(0.2), [](auto, auto, auto c) { return 0.3 + 0.1 * double(c); }},
          {"grey constants", constant(0.25), constant(0.75)},
          {"red against blue", primary(0), primary(2)},
          {"green against blue, the largest", primary(1), primary(2)},
          {"nearly constant", constant(0.5),
           [](auto x, auto y, auto c) { return 0.5 + noise(x, y, c) / 4096.0; }},
          {"dark", [](auto x, auto y, auto c) { return noise(x, y, c) / 64.0; },
           [](auto x, auto y, auto c) { return hashed(x, y, c, 2) / 64.0; }},
          {"HDR, clamped", [](auto x, auto y, auto c) { return 3.0 * rings(x, y, c); },
           [](auto x, auto y, auto c) { return 3.0 * grainy(x, y, c); }},
          {"negative values, clamped", [](auto x, auto y, auto c) { return noise(x, y, c) - 0.5; },
           [](auto x, auto y, auto c) { return rings(x, y, c) - 0.5; }},
          {"lines beside each other", lines(8), lines(9)},
          {"lone points gone",
           [](auto x, auto y, auto) { return 0.5 - 0.5 * double(x % 23 == 11 && y % 19 == 7); },
           constant(0.5)},
          {"waves, more rows than a band", waves,
           [](auto x, auto y, auto c) { return 0.9 * waves(x, y, c) + 0.1 * noise(x, y, c); }},
          {"equal", rings, rings}};
}

}  // namespace pellucid::compare::testing
