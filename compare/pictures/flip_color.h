// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The colours of FLIP (compare/pictures/flip.h): Andersson, Nilsson, Akenine-Möller, Oskarsson,
// Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", PACMCGIT 3(2), 2020.
// All in float, written so that loops over pixels vectorize.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pellucid::compare {

/// Returns the n-th root of t > 0: a guess from the exponent, within 8 %, and two of Halley's
/// steps, each of which cubes the relative error and multiplies it by (n² - 1) / 12 ≤ 2. What is
/// left is the rounding of float.
template <int n>
inline float root(float t) {
  constexpr float one = 0x3F800000;  // the bits of 1, as a number
  const float bits = one + (float(std::bit_cast<std::int32_t>(t)) - one) / n;
  float y = std::bit_cast<float>(std::int32_t(bits));
  for (int step = 0; step < 2; ++step) {
    float power = y;
    for (int i = 1; i < n; ++i) power *= y;
    y *= ((n - 1) * power + (n + 1) * t) / ((n + 1) * power + (n - 1) * t);
  }
  return y;
}

/// Returns the linear value of an sRGB value in [0, 1] (IEC 61966-2-1): x^2.4 is x² (x²)^(1/5).
inline float linear_of_srgb(float value) {
  const float x = (value + 0.055f) / 1.055f;
  const float curve = x * x * root<5>(x * x);
  return value > 0.04045f ? curve : value / 12.92f;
}

/// An OpponentColor holds y, x - y and y - z, where x, y, z are CIE XYZ over those of the white
/// point D65: the paper's YCxCz but for its scales (116 y - 16, 500, 200), which cancel, as filters
/// of these three are linear and keep constants.
struct OpponentColor {
  float y, xy, yz;
};

/// White in CIE XYZ, D65.
struct WhitePoint {
  static constexpr float x = 0.950428545f, z = 1.088900371f;
};

/// Returns the opponent colour of linear RGB in [0, 1].
inline OpponentColor opponent_of_linear(float r, float g, float b) {
  constexpr double by_x = 24577794, by_y = 12288897, by_z = 73733382;
  constexpr float xr = float(10135552 / by_x), xg = float(8788810 / by_x),
                  xb = float(4435075 / by_x);
  constexpr float yr = float(2613072 / by_y), yg = float(8788810 / by_y), yb = float(887015 / by_y);
  constexpr float zr = float(1425312 / by_z), zg = float(8788810 / by_z),
                  zb = float(70074185 / by_z);
  const float x = (xr * r + xg * g + xb * b) / WhitePoint::x;
  const float y = yr * r + yg * g + yb * b;
  const float z = (zr * r + zg * g + zb * b) / WhitePoint::z;
  return {y, x - y, y - z};
}

/// A HuntLab is a colour in L*a*b* whose a* and b* are multiplied by L* / 100 (the Hunt
/// effect): differences of dark colours count for less.
struct HuntLab {
  float l, a, b;
};

/// CIE L*a*b*'s function of x, y or z, each in [0, 1].
inline float lab_curve(float t) {
  constexpr float delta = 6.f / 29;
  const float line = t / (3 * delta * delta) + 4.f / 29;
  const float curve = root<3>(std::max(t, delta * delta * delta));
  return t > delta * delta * delta ? curve : line;
}

/// Returns the adjusted L*a*b* of linear RGB in [0, 1].
inline HuntLab hunt_lab_of_linear(float r, float g, float b) {
  const OpponentColor c = opponent_of_linear(r, g, b);
  const float fx = lab_curve(c.y + c.xy), fy = lab_curve(c.y), fz = lab_curve(c.y - c.yz);
  const float l = 116 * fy - 16;
  return {l, 0.01f * l * (500 * (fx - fy)), 0.01f * l * (200 * (fy - fz))};
}

/// A filtered colour may have left the cube of colours that a display shows: it is clamped to it.
inline HuntLab hunt_lab_of_opponent(const OpponentColor& c) {
  const float x = (c.y + c.xy) * WhitePoint::x, z = (c.y - c.yz) * WhitePoint::z;
  const auto clamped = [](float v) { return std::min(std::max(v, 0.f), 1.f); };
  return hunt_lab_of_linear(clamped(3.241003275f * x - 1.537398934f * c.y - 0.498615861f * z),
                            clamped(-0.969224334f * x + 1.875930071f * c.y + 0.041554224f * z),
                            clamped(0.055639423f * x - 0.204011202f * c.y + 1.057148933f * z));
}

/// Returns HyAB, the distance of two colours that keeps its meaning when it is large: city-block in
/// lightness, Euclidean in hue and chroma.
inline float hyab(const HuntLab& p, const HuntLab& q) {
  const float a = p.a - q.a, b = p.b - q.b;
  return std::abs(p.l - q.l) + std::sqrt(a * a + b * b);
}

}  // namespace pellucid::compare
