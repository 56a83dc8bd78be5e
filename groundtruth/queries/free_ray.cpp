// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/queries/free_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "groundtruth/rays/exact_number.h"

namespace pellucid::groundtruth {
namespace {

double size_of(const Triple<double>& p) {
  return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
}

/// The sign of the first that is not 0.
int first_sign(const Triple<Exact>& numbers) {
  for (const Exact& number : numbers)
    if (const int sign = sign_of(number); sign != 0) return sign;
  return 0;
}

/// A determinant of three vectors, and the sign that it has for the moved ray.
struct Decided {
  double value;
  int sign;
  double bound;  // of the rounding error of `value`; 0: it was in doubt and is exact, rounded once
};

/// Rounding error of det(x, y, z) in double, h = 2^-53, each vector rounded once and with
/// components within m_x, m_y, m_z: six products of three numbers, each off by at most 3 h for its
/// factors and 2 h for its two products, then up to 3 sums of at most 6 m_x m_y m_z: 6 · 5 h + 3 ·
/// 6 h = 48 h. Twice that leaves room for terms in h². The floor keeps it from underflowing; what
/// may overflow is in doubt, whatever its value.
double rounding_bound(double x, double y, double z) {
  const double size = x * y * z;
  if (!(size < 1e300)) return std::numeric_limits<double>::infinity();
  return std::max(96 * 0x1p-53 * size, 1e-280);
}

/// Where a determinant that is divided by is this many bounds large, the quotient errs by 2^-20 at
/// most; less is computed without rounding.
constexpr double sharp_from = 0x1p20;

/// Nor may it have left the numbers of full precision, or nearly.
bool is_sharp(const Decided& x) {
  const double size = std::abs(x.value);
  return size >= std::max(sharp_from * x.bound, 1e-280) && size < 1e300;
}

Exact exact_pass(const FreeRay& ray, const Vec3& p, const Vec3& q) {
  return dot_product(triple<Exact>(ray.direction), cross_product(difference<Exact>(p, ray.origin),
                                                                 difference<Exact>(q, ray.origin)));
}

Exact exact_height(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  return dot_product(
      difference<Exact>(a, ray.origin),
      cross_product(difference<Exact>(b, ray.origin), difference<Exact>(c, ray.origin)));
}

/// The side on which the ray passes the edge from p to q: det(d, p - o, q - o). Moved by s, the
/// origin changes it by s · ((p - q) × d), the direction by s · ((p - o) × (q - o)).
Decided pass(const FreeRay& ray, const Vec3& p, const Vec3& q) {
  const auto a = difference<double>(p, ray.origin), b = difference<double>(q, ray.origin),
             d = triple<double>(ray.direction);
  const double rounded = dot_product(d, cross_product(a, b));
  const double bound = rounding_bound(size_of(d), size_of(a), size_of(b));
  if (std::abs(rounded) > bound) return {rounded, sign_of(rounded), bound};
  const auto along = triple<Exact>(ray.direction);
  const auto normal =
      cross_product(difference<Exact>(p, ray.origin), difference<Exact>(q, ray.origin));
  const Exact exact = dot_product(along, normal);
  int sign = sign_of(exact);
  if (sign == 0) sign = first_sign(normal);  // the direction moves
  const auto edge = difference<Exact>(p, q);
  if (sign == 0) sign = first_sign(cross_product(edge, along));  // the origin moves
  // Both move, since the ray runs along the edge: det(e_i, e_j, p - q) ε_i η_j, of which ε² η, ε³ η
  // and ε³ η² are the largest that tell.
  if (sign == 0) sign = first_sign({-edge[2], edge[1], -edge[0]});
  return {CGAL::to_double(exact), sign, 0};
}

/// On which side of the triangle's plane the origin lies: det(a - o, b - o, c - o). Moved by s, the
/// origin changes it by -s · ((b - a) × (c - a)).
Decided height(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto p = difference<double>(a, ray.origin), q = difference<double>(b, ray.origin),
             r = difference<double>(c, ray.origin);
  const double rounded = dot_product(p, cross_product(q, r));
  const double bound = rounding_bound(size_of(p), size_of(q), size_of(r));
  if (std::abs(rounded) > bound) return {rounded, sign_of(rounded), bound};
  const Exact exact = exact_height(ray, a, b, c);
  int sign = sign_of(exact);
  if (sign == 0)
    sign = -first_sign(cross_product(difference<Exact>(b, a), difference<Exact>(c, a)));
  return {CGAL::to_double(exact), sign, 0};
}

/// A quotient that is 0 without a sign: a ray may begin on the triangle.
double ratio(double a, double b) { return a == 0 ? 0 : a / b; }

/// The same crossing without rounding but of the quotients, whatever the sizes of what is divided.
TriangleHit sharp_hit(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c, int side) {
  const Exact bc = exact_pass(ray, b, c), ca = exact_pass(ray, c, a), ab = exact_pass(ray, a, b);
  const Exact sum = bc + ca + ab;
  // The ray runs in the triangle's plane and begins on the triangle, since the moved one crosses
  // it.
  if (sign_of(sum) == 0) return {0, 1.0 / 3, 1.0 / 3, side};
  return {quotient(exact_height(ray, a, b, c), sum), quotient(ca, sum), quotient(ab, sum), side};
}

}  // namespace

std::optional<TriangleHit> cross(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Decided bc = pass(ray, b, c);
  const Decided ca = pass(ray, c, a);
  if (bc.sign == 0 || bc.sign != ca.sign) return std::nullopt;
  const Decided ab = pass(ray, a, b);
  if (ca.sign != ab.sign) return std::nullopt;
  // t = det(a - o, b - o, c - o) / Σ, and the sign of Σ is that of the edges.
  const Decided above = height(ray, a, b, c);
  if (above.sign != bc.sign) return std::nullopt;
  const Decided sum{bc.value + ca.value + ab.value, bc.sign,
                    std::max({bc.bound, ca.bound, ab.bound})};
  if (sum.bound == 0 || !is_sharp(sum) || !is_sharp(above)) return sharp_hit(ray, a, b, c, bc.sign);
  return TriangleHit{above.value / sum.value, ratio(ca.value, sum.value),
                     ratio(ab.value, sum.value), bc.sign};
}

double exact_t(const FreeRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  return sharp_hit(ray, a, b, c, 0).t;
}

}  // namespace pellucid::groundtruth
