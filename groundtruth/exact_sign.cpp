#include "groundtruth/exact_sign.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pellucid {
namespace {

using Exact = CGAL::Exact_rational;
using ExactVec = std::array<Exact, 3>;

ExactVec exact(const Vec3& v) { return {Exact(v.x), Exact(v.y), Exact(v.z)}; }

ExactVec difference(const Vec3& a, const Vec3& b) {
  return {Exact(a.x) - Exact(b.x), Exact(a.y) - Exact(b.y), Exact(a.z) - Exact(b.z)};
}

Exact determinant(const ExactVec& u, const ExactVec& v, const ExactVec& w) {
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

int sign_of(double x) { return (x > 0) - (x < 0); }
int sign_of(const Exact& x) { return static_cast<int>(CGAL::sign(x)); }

struct SignedValue {
  double value;
  int sign;  // of the perturbed edge function; 0 only when every perturbation gives 0
};

/// The first derivative of det(d, a - o, b - o) when the picture point moves along `step`: for a
/// perspective ray d moves, for an orthographic one o does, and
///   d/dε det(d, a - o - ε step, b - o - ε step) = det(d, step, a - b).
Exact derivative(const PictureRay& ray, const Vec3& a, const Vec3& b, const Vec3& step) {
  if (ray.projection == Projection::perspective)
    return determinant(exact(step), difference(a, ray.origin), difference(b, ray.origin));
  return determinant(exact(ray.direction), exact(step), difference(a, b));
}

/// The edge function of a → b and the sign of its perturbed value, without rounding.
SignedValue exact_edge(const PictureRay& ray, const Vec3& a, const Vec3& b) {
  const Exact e =
      determinant(exact(ray.direction), difference(a, ray.origin), difference(b, ray.origin));
  const double value = CGAL::to_double(e);
  if (const int sign = sign_of(e)) return {value, sign};
  if (const int sign = sign_of(derivative(ray, a, b, ray.step_x))) return {0, sign};
  return {0, sign_of(derivative(ray, a, b, ray.step_y))};
}

double max_norm(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Bound on the rounding error of det(d, A, B), A = a - o and B = b - o rounded, evaluated as
/// dot(d, cross(A, B)). With u = 2^-53 each of the six products of three factors carries at most
/// (1 + u)^7: two differences, two multiplications, the subtraction in the cross product, two
/// additions of the dot product. Their absolute values sum to at most 6 |d| |A| |B| in the maximum
/// norm, so the error is below 6 · 7.01 u |d| |A| |B|. 48 u leaves room for rounding in the bound.
constexpr double error_factor = 48 * 0x1p-53;

/// Below this the bound could underflow; the unit frame keeps scenes far above.
constexpr double smallest_bound = 1e-290;

SignedValue rounded_edge(const PictureRay& ray, const Vec3& a, const Vec3& b, double e) {
  return e != 0 ? SignedValue{e, sign_of(e)} : exact_edge(ray, a, b);
}

}  // namespace

bool crosses(const PictureRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
             Precision precision, EdgeFunctions& edges) {
  const Vec3 A = a - ray.origin, B = b - ray.origin, C = c - ray.origin;
  double(&e)[3] = edges.e;
  e[0] = glm::dot(ray.direction, glm::cross(B, C));
  e[1] = glm::dot(ray.direction, glm::cross(C, A));
  e[2] = glm::dot(ray.direction, glm::cross(A, B));

  // The largest of the three bounds serves all: certain signs decide almost every ray here.
  const double norm = std::max({max_norm(A), max_norm(B), max_norm(C)});
  const double bound =
      std::max(error_factor * max_norm(ray.direction) * norm * norm, smallest_bound);
  const double low = std::min({e[0], e[1], e[2]}), high = std::max({e[0], e[1], e[2]});
  if (low < -bound && high > bound) return false;
  if (low > bound || high < -bound) return true;

  const auto decide = [&](const Vec3& from, const Vec3& to, double value) -> SignedValue {
    if (precision == Precision::rounded) return rounded_edge(ray, from, to, value);
    return std::abs(value) > bound ? SignedValue{value, sign_of(value)} : exact_edge(ray, from, to);
  };
  const SignedValue s0 = decide(b, c, e[0]), s1 = decide(c, a, e[1]), s2 = decide(a, b, e[2]);
  edges = {{s0.value, s1.value, s2.value}};
  return s0.sign != 0 && s0.sign == s1.sign && s1.sign == s2.sign;
}

}  // namespace pellucid
