// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/seed_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace pellucid::integrators {
namespace {

constexpr double two_pi = 6.283185307179586476925286766559;

bool is_finite(const Vec3& x) {
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

/// The points without repetitions in a row; a closed curve's first point once more at its end.
std::vector<Vec3> distinct_points(std::span<const Vec3> points, bool closed) {
  std::vector<Vec3> distinct;
  for (const Vec3& x : points) {
    if (!is_finite(x))
      throw InputError(fmt::format("seed curve: point ({}, {}, {}) is not finite", x.x, x.y, x.z));
    if (distinct.empty() || x != distinct.back()) distinct.push_back(x);
  }
  if (closed && distinct.size() > 1 && distinct.front() != distinct.back())
    distinct.push_back(distinct.front());
  if (distinct.size() < 2)
    throw InputError("seed curve: it has no length; accepted: at least two different points");
  return distinct;
}

/// Knots in [0, 1] that advance by |x_{i+1} - x_i|^power.
std::vector<double> knots_of(const std::vector<Vec3>& points, double power) {
  std::vector<double> knots{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    knots.push_back(knots.back() + std::pow(glm::distance(points[i - 1], points[i]), power));
  for (double& knot : knots) knot /= knots.back();
  return knots;
}

/// The piece [knots[i], knots[i + 1]) that holds s.
std::size_t piece_of(const std::vector<double>& knots, double s) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, s);
  return std::size_t(above - knots.begin()) - 1;
}

/// The knots at which one piece's direction is not the next one's: a point on a straight line is no
/// corner.
std::vector<double> corners_of(const std::vector<Vec3>& x, const std::vector<double>& knots,
                               bool closed) {
  constexpr double straight = 1e-6;  // radians: some rounding of coordinates
  const std::size_t pieces = x.size() - 1;
  const auto direction = [&](std::size_t i) { return glm::normalize(x[i + 1] - x[i]); };
  std::vector<double> corners;
  for (std::size_t i = closed ? 0 : 1; i < pieces; ++i)
    if (glm::distance(direction(i), direction((i + pieces - 1) % pieces)) > straight)
      corners.push_back(knots[i]);
  return corners;
}

/// A cubic through x0 and x1 with the tangents m0 and m1 over a knot distance h.
struct HermitePiece {
  Vec3 x0, x1, m0, m1;
  double h;

  Vec3 point(double u) const {
    const double v = 1 - u;
    return (v * v * (1 + 2 * u)) * x0 + (u * u * (1 + 2 * v)) * x1 +
           h * ((u * v * v) * m0 - (u * u * v) * m1);
  }
  Vec3 tangent(double u) const {
    const double v = 1 - u;
    return (6 * u * v / h) * (x1 - x0) + (v * (1 - 3 * u)) * m0 + (u * (3 * u - 2)) * m1;
  }
};

/// The slope at the middle one of three knots of the parabola through them.
Vec3 parabola_slope(const Vec3& before, const Vec3& here, const Vec3& after, double h0, double h1) {
  const Vec3 slope0 = (here - before) / h0, slope1 = (after - here) / h1;
  return (h1 * slope0 + h0 * slope1) / (h0 + h1);
}

std::vector<Vec3> spline_slopes(const std::vector<Vec3>& x, const std::vector<double>& knots,
                                bool closed) {
  const std::size_t last = x.size() - 1;
  const auto h = [&](std::size_t i) { return knots[i + 1] - knots[i]; };
  std::vector<Vec3> slopes(x.size());
  for (std::size_t i = 1; i < last; ++i)
    slopes[i] = parabola_slope(x[i - 1], x[i], x[i + 1], h(i - 1), h(i));
  if (closed) {
    slopes[0] = parabola_slope(x[last - 1], x[0], x[1], h(last - 1), h(0));
    slopes[last] = slopes[0];
  } else {
    // The end parabola's slope at its end.
    slopes[0] = 2.0 * (x[1] - x[0]) / h(0) - (last > 1 ? slopes[1] : (x[1] - x[0]) / h(0));
    slopes[last] = 2.0 * (x[last] - x[last - 1]) / h(last - 1) -
                   (last > 1 ? slopes[last - 1] : (x[1] - x[0]) / h(0));
  }
  return slopes;
}

}  // namespace

SeedCurve segment_seed(const Vec3& from, const Vec3& to) {
  const Vec3 ends[] = {from, to};
  return polyline_seed(ends);
}

SeedCurve polyline_seed(std::span<const Vec3> points, bool closed) {
  const auto x = distinct_points(points, closed);
  const auto knots = knots_of(x, 1);
  SeedCurve curve;
  curve.closed = closed;
  curve.corners = corners_of(x, knots, closed);
  curve.point_at = [x, knots](double s) {
    const std::size_t i = piece_of(knots, s);
    const double u = (s - knots[i]) / (knots[i + 1] - knots[i]);
    return (1 - u) * x[i] + u * x[i + 1];
  };
  curve.tangent_at = [x, knots](double s) {
    const std::size_t i = piece_of(knots, s);
    return (x[i + 1] - x[i]) / (knots[i + 1] - knots[i]);
  };
  return curve;
}

SeedCurve circle_seed(const Vec3& center, const Vec3& normal, double radius) {
  if (!is_finite(center) || !is_finite(normal) || normal == Vec3(0) || !(radius > 0) ||
      !std::isfinite(radius))
    throw InputError("seed circle: accepted: a finite center, a normal ≠ 0 and a radius > 0");
  const Vec3 n = glm::normalize(normal);
  const Vec3 least = std::abs(n.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 a = radius * glm::normalize(glm::cross(n, least)), b = glm::cross(n, a);
  return {true,
          [=](double s) { return center + std::cos(two_pi * s) * a + std::sin(two_pi * s) * b; },
          [=](double s) { return two_pi * (std::cos(two_pi * s) * b - std::sin(two_pi * s) * a); },
          {}};
}

SeedCurve spline_seed(std::span<const Vec3> points, bool closed) {
  const auto x = distinct_points(points, closed);
  const auto knots = knots_of(x, 0.5);
  const auto slopes = spline_slopes(x, knots, closed);
  const auto piece = [x, knots, slopes](std::size_t i) {
    return HermitePiece{x[i], x[i + 1], slopes[i], slopes[i + 1], knots[i + 1] - knots[i]};
  };
  const auto local = [knots](std::size_t i, double s) {
    return (s - knots[i]) / (knots[i + 1] - knots[i]);
  };
  return {closed,
          [=](double s) {
            const std::size_t i = piece_of(knots, s);
            return piece(i).point(local(i, s));
          },
          [=](double s) {
            const std::size_t i = piece_of(knots, s);
            return piece(i).tangent(local(i, s));
          },
          {}};
}

SeedCurve callable_seed(std::function<Vec3(double)> point, bool closed,
                        std::function<Vec3(double)> tangent) {
  if (!tangent)
    tangent = [point, closed](double s) {
      constexpr double h = 1e-5;  // balances truncation h² against rounding ε / h
      const double s0 = closed ? s - h : std::max(s - h, 0.0);
      const double s1 = closed ? s + h : std::min(s + h, 1.0);
      const auto wrapped = [&](double at) { return point(closed ? at - std::floor(at) : at); };
      return (wrapped(s1) - wrapped(s0)) / (s1 - s0);
    };
  return {closed, std::move(point), std::move(tangent), {}};
}

}  // namespace pellucid::integrators
