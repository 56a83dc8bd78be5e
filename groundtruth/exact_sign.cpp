#include "groundtruth/exact_sign.h"

#include <CGAL/Gmpzf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pellucid {
namespace {

/// A binary floating-point number of unbounded mantissa: sums and products of doubles without
/// rounding, and without the common divisors that rationals have to look for.
using Exact = CGAL::Gmpzf;
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

double max_norm(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Bound on the rounding error of det(u, V, W), V and W differences of two doubles, evaluated as
/// dot(u, cross(V, W)). With h = 2^-53 each of the six products of three factors carries at most
/// (1 + h)^7: two differences, two multiplications, the subtraction in the cross product, two
/// additions of the dot product. Their absolute values sum to at most 6 |u| |V| |W| in the maximum
/// norm, so the error is below 6 · 7.01 h |u| |V| |W|. 48 h leaves room for rounding in the bound.
constexpr double error_factor = 48 * 0x1p-53;

/// Below this the bound could underflow; the unit frame keeps scenes far above.
constexpr double smallest_bound = 1e-290;

double error_bound(const Vec3& u, double norm_v, double norm_w) {
  return std::max(error_factor * max_norm(u) * norm_v * norm_w, smallest_bound);
}

struct SignedValue {
  double value;
  int sign;
};

/// det(u, a - o, b - o) without rounding.
Exact exact_edge(const Vec3& u, const Vec3& o, const Vec3& a, const Vec3& b) {
  return determinant(exact(u), difference(a, o), difference(b, o));
}

/// The exact sign of det(u, a - o, b - o).
int edge_sign(const Vec3& u, const Vec3& o, const Vec3& a, const Vec3& b) {
  const Vec3 A = a - o, B = b - o;
  const double value = glm::dot(u, glm::cross(A, B));
  if (std::abs(value) > error_bound(u, max_norm(A), max_norm(B))) return sign_of(value);
  return sign_of(exact_edge(u, o, a, b));
}

/// The exact sign of det(u, v, a - b).
int translation_sign(const Vec3& u, const Vec3& v, const Vec3& a, const Vec3& b) {
  const Vec3 D = a - b;
  const double value = glm::dot(u, glm::cross(v, D));
  if (std::abs(value) > error_bound(u, max_norm(v), max_norm(D))) return sign_of(value);
  return sign_of(determinant(exact(u), exact(v), difference(a, b)));
}

/// The sign of the first derivative of det(d, a - o, b - o) when the picture point moves along
/// `step`: for a perspective ray d moves, for an orthographic one o does, and
///   d/dε det(d, a - o - ε step, b - o - ε step) = det(d, step, a - b).
int derivative_sign(const PictureRay& ray, const Vec3& a, const Vec3& b, const Vec3& step) {
  if (ray.projection == Projection::perspective) return edge_sign(step, ray.origin, a, b);
  return translation_sign(ray.direction, step, a, b);
}

/// The sign of a vanishing edge function when the picture point moves by (ε, ε²); 0 only when
/// the edge is seen as a point.
int perturbed_sign(const PictureRay& ray, const Vec3& a, const Vec3& b) {
  const int sign = derivative_sign(ray, a, b, ray.step_x);
  return sign != 0 ? sign : derivative_sign(ray, a, b, ray.step_y);
}

/// An edge function that the filter could not decide.
SignedValue decide(const PictureRay& ray, const Vec3& a, const Vec3& b, double rounded,
                   Precision precision) {
  SignedValue edge{rounded, sign_of(rounded)};
  if (precision == Precision::exact) {
    const Exact e = exact_edge(ray.direction, ray.origin, a, b);
    edge = {CGAL::to_double(e), sign_of(e)};
  }
  if (edge.sign == 0) edge.sign = perturbed_sign(ray, a, b);
  return edge;
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
  const double bound = error_bound(ray.direction, norm, norm);
  const double low = std::min({e[0], e[1], e[2]}), high = std::max({e[0], e[1], e[2]});
  if (low < -bound && high > bound) return false;
  if (low > bound || high < -bound) return true;

  const auto sign = [&](const Vec3& from, const Vec3& to, double value) -> SignedValue {
    if (std::abs(value) > bound) return {value, sign_of(value)};
    return decide(ray, from, to, value, precision);
  };
  const SignedValue s0 = sign(b, c, e[0]), s1 = sign(c, a, e[1]), s2 = sign(a, b, e[2]);
  edges = {{s0.value, s1.value, s2.value}};
  return s0.sign != 0 && s0.sign == s1.sign && s1.sign == s2.sign;
}

}  // namespace pellucid
