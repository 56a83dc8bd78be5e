// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/exact_sign.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/rays/exact_number.h"

namespace pellucid::groundtruth {
namespace {

template <class Number>
struct Plane2 {
  Number x, y;
};

/// a' of EdgeFunctions.
template <class Number>
Plane2<Number> shear(const PictureRay& ray, const Vec3& a) {
  if (ray.projection == scene::Projection::perspective)
    return {Number(a.x) - Number(ray.x) * Number(a.z), Number(a.y) - Number(ray.y) * Number(a.z)};
  return {Number(a.x) - Number(ray.x), Number(a.y) - Number(ray.y)};
}

template <class Number>
Number cross(const Plane2<Number>& p, const Plane2<Number>& q) {
  return p.x * q.y - p.y * q.x;
}

/// Rounding error of an edge function in double, h = 2^-53 and all coordinates within `largest`:
/// with m = largest · (1 + |x| or |y|), or largest + |x| or |y|, a component of a' is below m and
/// off by at most 2 h m (one product, one difference). A product of two components is then off by
/// at most 2 · 2 h m² + h m² and terms in h², their difference by twice that and its own rounding
/// of 2 h m²: 12 h m². 16 h leaves room for the h² terms and for the rounding of m. The floor keeps
/// it from underflowing.
double rounding_bound(const PictureRay& ray, double largest) {
  const double offset = std::max(std::abs(ray.x), std::abs(ray.y));
  const bool perspective = ray.projection == scene::Projection::perspective;
  const double m = perspective ? largest * (1 + offset) : largest + offset;
  return std::max(16 * 0x1p-53 * m * m, 1e-290);
}

/// The exact sign of a b - c d.
int minor_sign(double a, double b, double c, double d) {
  const double p = a * b, q = c * d;
  // Each product carries one rounding and their difference a third.
  if (std::abs(p - q) > 4 * 0x1p-53 * (std::abs(p) + std::abs(q)) + 1e-290) return sign_of(p - q);
  return sign_of(Exact(a) * Exact(b) - Exact(c) * Exact(d));
}

/// The sign that a vanishing edge function a' × b' takes when the picture point moves by (ε, ε²)
/// to the right and down: that of its first derivative along the picture's x, or else along -y,
///   ∂/∂x det((x, y, 1), a, b) = a.y b.z - a.z b.y,  -∂/∂y = a.x b.z - a.z b.x   (perspective),
///   ∂/∂x = a.y - b.y,  -∂/∂y = a.x - b.x                                        (orthographic).
/// 0 only when the edge is seen as a point.
int perturbed_sign(const PictureRay& ray, const Vec3& a, const Vec3& b) {
  if (ray.projection == scene::Projection::orthographic)
    return a.y != b.y ? sign_of(a.y - b.y) : sign_of(a.x - b.x);
  const int sign = minor_sign(a.y, b.z, a.z, b.y);
  return sign != 0 ? sign : minor_sign(a.x, b.z, a.z, b.x);
}

struct SignedValue {
  double value;
  int sign;
};

/// An edge function that the filter could not decide.
SignedValue decide(const PictureRay& ray, const Vec3& a, const Vec3& b, double rounded,
                   Precision precision) {
  SignedValue edge{rounded, sign_of(rounded)};
  if (precision == Precision::exact) {
    const Exact e = cross(shear<Exact>(ray, a), shear<Exact>(ray, b));
    edge = {CGAL::to_double(e), sign_of(e)};
  }
  if (edge.sign == 0) edge.sign = perturbed_sign(ray, a, b);
  return edge;
}

}  // namespace

RayPredicate::RayPredicate(const PictureRay& ray, double largest, Precision precision)
    : ray_(ray),
      precision_(precision),
      bound_(rounding_bound(ray, largest)),
      sharp_from_(precision == Precision::exact ? 0x1p20 * bound_ : 0) {}

bool RayPredicate::crosses(const Vec3& a, const Vec3& b, const Vec3& c,
                           EdgeFunctions& edges) const {
  const Plane2 p = shear<double>(ray_, a), q = shear<double>(ray_, b), r = shear<double>(ray_, c);
  double(&e)[3] = edges.e;
  e[0] = cross(q, r);
  e[1] = cross(r, p);
  e[2] = cross(p, q);
  const double low = std::min({e[0], e[1], e[2]}), high = std::max({e[0], e[1], e[2]});
  if (low < -bound_ && high > bound_) return false;
  if (low > bound_ || high < -bound_) return true;
  return crosses_uncertain(a, b, c, edges);
}

bool RayPredicate::crosses_uncertain(const Vec3& a, const Vec3& b, const Vec3& c,
                                     EdgeFunctions& edges) const {
  const auto sign = [&](const Vec3& from, const Vec3& to, double value) -> SignedValue {
    if (std::abs(value) > bound_) return {value, sign_of(value)};
    return decide(ray_, from, to, value, precision_);
  };
  const SignedValue s0 = sign(b, c, edges.e[0]), s1 = sign(c, a, edges.e[1]),
                    s2 = sign(a, b, edges.e[2]);
  edges = {{s0.value, s1.value, s2.value}};
  return s0.sign != 0 && s0.sign == s1.sign && s1.sign == s2.sign;
}

void RayPredicate::recompute(const Vec3& a, const Vec3& b, const Vec3& c,
                             EdgeFunctions& edges) const {
  const Plane2 p = shear<Exact>(ray_, a), q = shear<Exact>(ray_, b), r = shear<Exact>(ray_, c);
  edges = {
      {CGAL::to_double(cross(q, r)), CGAL::to_double(cross(r, p)), CGAL::to_double(cross(p, q))}};
}

bool RayPredicate::crosses_disc(const Vec3& center, double radius, double& squared_distance) const {
  const Plane2 p = shear<double>(ray_, center);
  squared_distance = p.x * p.x + p.y * p.y;
  const double e = squared_distance - radius * radius;
  // As in rounding_bound: each square is off by 5 h m², their sum by 2 h m² more, the radius's
  // square by h m² and the difference by 2 h m²: 15 h m² and terms in h², within twice the bound.
  if (std::abs(e) > 2 * bound_) return e < 0;
  int sign = sign_of(e);
  if (precision_ == Precision::exact) {
    const Plane2 q = shear<Exact>(ray_, center);
    sign = sign_of(q.x * q.x + q.y * q.y - Exact(radius) * Exact(radius));
  }
  // On the rim: p.x is positive where the centre lies to the right. Rounding does not change its
  // sign where it is not 0, and straight above and below the centre the rim is left either way.
  return sign != 0 ? sign < 0 : p.x > 0;
}

}  // namespace pellucid::groundtruth
