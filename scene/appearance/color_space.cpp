// SPDX-License-Identifier: GPL-3.0-or-later
// Colours between two colours.
//   Lab        CIE 1976 L*a*b*, of sRGB (IEC 61966-2-1) with its white, D65.
//   Diverging  K. Moreland: Diverging Color Maps for Scientific Visualization, ISVC 2009, Sect. 5:
//              Msh, the polar coordinates of Lab, through white between colours of other hues.
//              ParaView's maps are drawn as VTK draws them (vtkColorTransferFunction), whose code
//              has 0.33 π and 0.3 π where the paper has π/3.

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
  return saturated.hue > -0.3 * pi ? saturated.hue + spin : saturated.hue - spin;
}

/// InterpolateColor of Moreland's Fig. 6.
Vec3 between_in_msh(const Vec3& from, const Vec3& to, double x) {
  Msh a = msh_of(lab_of(from)), b = msh_of(lab_of(to));
  constexpr double saturated = 0.05, other_hue = 0.33 * pi, whitest = 88;
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

/// Whether the chord between two places of an interval is near to the colours there: to less than a
/// quarter of 1/255, at its quarters.
bool is_straight(const ColorSpace& space, const Vec3& from, const Vec3& to, const Vec2& part) {
  const Vec3 begin = space.between(from, to, part.x), end = space.between(from, to, part.y);
  for (const double x : {0.25, 0.5, 0.75}) {
    const Vec3 color = space.between(from, to, std::lerp(part.x, part.y, x));
    const Vec3 off = glm::abs(color - glm::mix(begin, end, x));
    if (std::max({off.x, off.y, off.z}) > 0.25 / 255) return false;
  }
  return true;
}

/// Appends the stops of a part of the interval, without its end: halved while the colours bend,
/// which they do sharply where they leave what sRGB has. Diverging has its corner in the middle.
void add_stops(const ColorSpace& space, const ColorStop& from, const ColorStop& to,
               const Vec2& part, int halvings, std::vector<ColorStop>& all) {
  constexpr int least = 4, most = 16;
  if (halvings < least || (halvings < most && !is_straight(space, from.color, to.color, part))) {
    const double middle = (part.x + part.y) / 2;
    add_stops(space, from, to, {part.x, middle}, halvings + 1, all);
    add_stops(space, from, to, {middle, part.y}, halvings + 1, all);
    return;
  }
  // Between stops that are next to each other as numbers there is no room.
  const double at = std::lerp(from.at, to.at, part.x);
  if (part.x == 0 || (at > all.back().at && at < to.at))
    all.push_back({at, space.between(from.color, to.color, part.x)});
}

}  // namespace

std::span<const ColorSpace> color_spaces() { return spaces; }

std::vector<ColorStop> linear_in_rgb(const std::vector<ColorStop>& stops, const ColorSpace& space) {
  if (space.between == between_in_rgb || stops.empty()) return stops;
  std::vector<ColorStop> all;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    add_stops(space, stops[i], stops[i + 1], {0, 1}, 0, all);
  all.push_back(stops.back());
  return all;
}

}  // namespace pellucid::scene
