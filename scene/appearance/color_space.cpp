// SPDX-License-Identifier: GPL-3.0-or-later
// Colours between two colours.
//   Lab        CIE 1976 L*a*b*, of sRGB (IEC 61966-2-1) with its white, D65.
//   Diverging  K. Moreland: Diverging Color Maps for Scientific Visualization, ISVC 2009, Sect. 5:
//              Msh, the polar coordinates of Lab, through white between colours of other hues.

#include "scene/appearance/color_space.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

namespace pellucid::scene {
namespace {

constexpr double pi = glm::pi<double>();

/// By columns: what red, green and blue are in X, Y, Z.
const Mat3 xyz_from_rgb(Vec3(0.4124, 0.2126, 0.0193), Vec3(0.3576, 0.7152, 0.1192),
                        Vec3(0.1805, 0.0722, 0.9505));
const Vec3 white = xyz_from_rgb * Vec3(1);

double decoded(double c) { return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92; }
double encoded(double c) {
  return c > 0.0031308 ? 1.055 * std::pow(c, 1 / 2.4) - 0.055 : 12.92 * c;
}

// CIE's cube root, with its tangent below (6/29)³.
constexpr double knee = 6.0 / 29;
double root(double t) {
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29;
}
double cube(double f) { return f > knee ? f * f * f : 3 * knee * knee * (f - 4.0 / 29); }

Vec3 each(double (*map)(double), const Vec3& v) { return {map(v.x), map(v.y), map(v.z)}; }

Vec3 lab_of(const Vec3& rgb) {
  const Vec3 f = each(root, xyz_from_rgb * each(decoded, rgb) / white);
  return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

/// What sRGB does not have is brought to its brightest, or loses the channel.
Vec3 rgb_of(const Vec3& lab) {
  const double y = (lab.x + 16) / 116;
  const Vec3 xyz = white * each(cube, Vec3(y + lab.y / 500, y, y - lab.z / 200));
  Vec3 rgb = each(encoded, glm::max(glm::inverse(xyz_from_rgb) * xyz, Vec3(0)));
  return rgb / std::max({1.0, rgb.x, rgb.y, rgb.z});
}

struct Msh {
  double magnitude, saturation, hue;  // of Lab; angles from white's axis and around it, radians
};

Msh msh_of(const Vec3& lab) {
  const double m = glm::length(lab);
  const double s = m > 1e-3 ? std::acos(std::clamp(lab.x / m, -1.0, 1.0)) : 0;
  return {m, s, s > 1e-3 ? std::atan2(lab.z, lab.y) : 0};
}

Vec3 lab_of(const Msh& c) {
  const double chroma = c.magnitude * std::sin(c.saturation);
  return {c.magnitude * std::cos(c.saturation), chroma * std::cos(c.hue), chroma * std::sin(c.hue)};
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

/// AdjustHue of Moreland's Fig. 6: the hue from which a colour without one is left, so that the
/// path is perceptually even.
double adjusted_hue(const Msh& saturated, double unsaturated_magnitude) {
  if (saturated.magnitude >= unsaturated_magnitude - 0.1) return saturated.hue;
  const double m = saturated.magnitude, other = unsaturated_magnitude;
  const double spin = saturated.saturation * std::sqrt(other * other - m * m) /
                      (m * std::sin(saturated.saturation));
  return saturated.hue > -pi / 3 ? saturated.hue + spin : saturated.hue - spin;
}

/// InterpolateColor of Moreland's Fig. 6.
Vec3 between_in_msh(const Vec3& from, const Vec3& to, double x) {
  Msh a = msh_of(lab_of(from)), b = msh_of(lab_of(to));
  constexpr double saturated = 0.05, other_hue = pi / 3, whitest = 88;
  if (a.saturation > saturated && b.saturation > saturated &&
      angle_between(a.hue, b.hue) > other_hue) {
    const Msh middle{std::max({a.magnitude, b.magnitude, whitest}), 0, 0};
    (x < 0.5 ? b : a) = middle;
    x = x < 0.5 ? 2 * x : 2 * x - 1;
  }
  if (a.saturation < saturated && b.saturation > saturated)
    a.hue = adjusted_hue(b, a.magnitude);
  else if (b.saturation < saturated && a.saturation > saturated)
    b.hue = adjusted_hue(a, b.magnitude);
  return rgb_of(lab_of(Msh{std::lerp(a.magnitude, b.magnitude, x),
                           std::lerp(a.saturation, b.saturation, x), std::lerp(a.hue, b.hue, x)}));
}

Vec3 between_in_lab(const Vec3& from, const Vec3& to, double x) {
  return rgb_of(glm::mix(lab_of(from), lab_of(to), x));
}

Vec3 between_in_rgb(const Vec3& from, const Vec3& to, double x) { return glm::mix(from, to, x); }

constexpr ColorSpace spaces[] = {
    {"RGB", between_in_rgb}, {"Lab", between_in_lab}, {"Diverging", between_in_msh}};

/// The chord of so small a part of an interval is less than 1/255 off, from black to white as well.
/// An even number, since Diverging has its corner in the middle.
constexpr int parts = 64;

}  // namespace

std::span<const ColorSpace> color_spaces() { return spaces; }

std::vector<ColorStop> linear_in_rgb(const std::vector<ColorStop>& stops, const ColorSpace& space) {
  if (space.between == between_in_rgb || stops.empty()) return stops;
  std::vector<ColorStop> all;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const double x = double(k) / parts;
      all.push_back({std::lerp(stops[i].at, stops[i + 1].at, x),
                     space.between(stops[i].color, stops[i + 1].color, x)});
    }
  all.push_back(stops.back());
  return all;
}

}  // namespace pellucid::scene
