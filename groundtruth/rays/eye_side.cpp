// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/eye_side.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "groundtruth/rays/exact_line.h"

namespace pellucid::groundtruth {
namespace {

/// In front of the eye, but nothing is nearer.
constexpr double in_front = std::numeric_limits<double>::min();

using Offset = Triple<Exact>;

int side_of_ball(const Offset& from_center, const Exact& radius) {
  return sign_of(dot_product(from_center, from_center) - radius * radius);
}

/// The sign of √x + y, of x that is not below 0.
int sign_of_root_plus(const Exact& x, const Exact& y) {
  if (sign_of(y) >= 0) return std::max(sign_of(x), sign_of(y));
  return sign_of(x - y * y);
}

/// On which side of the frustum around which the balls' common tangents run lies what is `from_a`?
/// With d = b - a, L = |d|, Δ = ra - rb and sin β = Δ / L, a tangent touches the balls at the angle
/// β from the plane across d: where s, the place along d from the middle, is ra sin β - L/2 and
/// rb sin β + L/2. Between them it is cos β ρ + sin β s = (ra + rb) / 2, ρ the distance from the
/// axis. Times L², with s = (from_a · d) / L - L/2 and ρ = |from_a × d| / L, what lies on the outer
/// side has
///   √((L² - Δ²) |from_a × d|²) + Δ (from_a · d) - ra L² > 0,
/// and the ends are at from_a · d = ra Δ and L² + rb Δ. Nothing lies in it where |Δ| ≥ L: one ball
/// holds the other.
int side_of_frustum(const Offset& from_a, const Offset& along, const Exact& radius_a,
                    const Exact& radius_b) {
  const Exact squared_length = dot_product(along, along), delta = radius_a - radius_b;
  const Exact rest = squared_length - delta * delta;
  const Exact place = dot_product(from_a, along);
  const bool between = sign_of(rest) > 0 && sign_of(place - radius_a * delta) >= 0 &&
                       sign_of(place - squared_length - radius_b * delta) <= 0;
  if (!between) return 1;
  const Offset across = cross_product(from_a, along);
  return sign_of_root_plus(rest * dot_product(across, across),
                           delta * place - radius_a * squared_length);
}

}  // namespace

// The hull is the balls and the frustum together, each with its surface.
int eye_side(const ViewFrame& frame, const PictureRay& ray, const Ball& a, const Ball& b) {
  const double scale = frame.units_per_length();
  const Offset eye = line<Exact>(frame.camera(), ray, scale).origin;
  const Offset from_a = difference(eye, triple<Exact>(a.center));
  const Offset from_b = difference(eye, triple<Exact>(b.center));
  const Exact radius_a(a.radius / scale), radius_b(b.radius / scale);
  return std::min(
      {side_of_ball(from_a, radius_a), side_of_ball(from_b, radius_b),
       side_of_frustum(from_a, difference<Exact>(b.center, a.center), radius_a, radius_b)});
}

SolidDepths with_signs_of(int eye_side, SolidDepths depths) {
  auto& [enters, leaves] = depths;
  if (eye_side == 0) (std::abs(enters) <= std::abs(leaves) ? enters : leaves) = 0;
  const bool entered = eye_side < 0 || (eye_side == 0 && enters == 0);
  const bool ahead = eye_side > 0 && enters + leaves > 0;
  if (entered || ahead) leaves = std::max(leaves, in_front);
  if (ahead) enters = std::max(enters, in_front);
  if (!ahead) enters = std::min(enters, 0.0);
  if (!ahead && !entered) leaves = std::min(leaves, 0.0);
  return depths;
}

}  // namespace pellucid::groundtruth
