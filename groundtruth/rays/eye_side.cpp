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

}  // namespace

int eye_side(const ViewFrame& frame, const PictureRay& ray, const Vec3& a, const Vec3& b,
             double radius) {
  const double scale = frame.units_per_length();
  const Triple<Exact> eye = line<Exact>(frame.camera(), ray, scale).origin;
  const Triple<Exact> from_a = difference(eye, triple<Exact>(a));
  const Triple<Exact> from_b = difference(eye, triple<Exact>(b));
  const Triple<Exact> along = difference<Exact>(b, a);
  const Exact squared_radius = Exact(radius / scale) * Exact(radius / scale);
  const Exact place = dot_product(from_a, along), squared_length = dot_product(along, along);
  if (sign_of(place) <= 0) return sign_of(dot_product(from_a, from_a) - squared_radius);
  if (sign_of(place - squared_length) >= 0)
    return sign_of(dot_product(from_b, from_b) - squared_radius);
  const Triple<Exact> across = cross_product(from_a, along);
  return sign_of(dot_product(across, across) - squared_radius * squared_length);
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
