// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/linear_cells.h"

#include <algorithm>
#include <cmath>

namespace pellucid::fields {
namespace {

/// Where a hexahedron's corners are in parametric coordinates.
constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// Six times the volume that three arms span.
double spanned(const Vec3& a, const Vec3& b, const Vec3& c) {
  return glm::dot(a, glm::cross(b, c));
}

/// X(p) = a0 + a1 p + a2 q + a3 r + a4 p q + a5 q r + a6 r p + a7 p q r.
struct Trilinear {
  explicit Trilinear(const std::array<Vec3, 8>& x) {
    a[0] = x[0];
    a[1] = x[1] - x[0];
    a[2] = x[3] - x[0];
    a[3] = x[4] - x[0];
    a[4] = (x[2] - x[3]) - a[1];
    a[5] = (x[7] - x[4]) - a[2];
    a[6] = (x[5] - x[1]) - a[3];
    a[7] = ((x[6] - x[7]) - (x[5] - x[4])) - a[4];
  }
  Vec3 value(const Vec3& p) const {
    return a[0] + p.x * a[1] + p.y * (a[2] + p.x * a[4]) +
           p.z * (a[3] + p.x * a[6] + p.y * (a[5] + p.x * a[7]));
  }
  Mat3 slopes(const Vec3& p) const {
    return {a[1] + p.y * a[4] + p.z * (a[6] + p.y * a[7]),
            a[2] + p.x * a[4] + p.z * (a[5] + p.x * a[7]),
            a[3] + p.x * a[6] + p.y * (a[5] + p.x * a[7])};
  }
  Vec3 a[8];
};

bool is_beyond(const std::array<Vec3, 8>& arms) {
  Vec3 low = arms[0], high = arms[0];
  for (std::size_t i = 1; i < 8; ++i) {
    low = glm::min(low, arms[i]);
    high = glm::max(high, arms[i]);
  }
  return low.x > 0 || low.y > 0 || low.z > 0 || high.x < 0 || high.y < 0 || high.z < 0;
}

}  // namespace

bool is_in_tetrahedron(const std::array<Vec3, 4>& arms) {
  // Outside, some volumes have another sign than others: most often two are enough to tell.
  const Vec3 of_01 = glm::cross(arms[0], arms[1]), of_23 = glm::cross(arms[2], arms[3]);
  const double a = glm::dot(arms[1], of_23), b = -glm::dot(arms[0], of_23);
  if (a * b < 0) return false;
  const double c = glm::dot(arms[3], of_01), d = -glm::dot(arms[2], of_01);
  const auto [least, most] = std::minmax({a, b, c, d});
  const double sum = (a + b) + (c + d);
  return sum > 0 ? least >= 0 : sum < 0 && most <= 0;
}

Side place_in_hexahedron(const std::array<Vec3, 8>& arms, Vec3& parametric) {
  constexpr int most_steps = 10;
  constexpr double close = 1e-8;  // of a step, after which one more squares what is left
  constexpr double far = 4;       // from the cell, of what may still come back
  if (is_beyond(arms)) return Side::outside;
  const Trilinear cell(arms);
  Vec3 p(0.5);
  for (int i = 0; i < most_steps; ++i) {
    const Mat3 slopes = cell.slopes(p);
    const Vec3 miss = cell.value(p);
    const double volume = spanned(slopes[0], slopes[1], slopes[2]);
    const Vec3 step = Vec3(spanned(miss, slopes[1], slopes[2]), spanned(slopes[0], miss, slopes[2]),
                           spanned(slopes[0], slopes[1], miss)) /
                      volume;
    p -= step;
    const double length = std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
    const double away = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (!(length < far && away < far)) return Side::unsure;  // not a number among them
    if (length > close) continue;
    parametric = p;
    const bool is_inside = p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= 1 && p.y <= 1 && p.z <= 1;
    return is_inside ? Side::inside : Side::outside;
  }
  return Side::unsure;
}

std::array<double, 8> hexahedron_weights(const Vec3& p) {
  std::array<double, 8> weights;
  for (std::size_t i = 0; i < 8; ++i)
    weights[i] = (corners[i][0] ? p.x : 1 - p.x) * (corners[i][1] ? p.y : 1 - p.y) *
                 (corners[i][2] ? p.z : 1 - p.z);
  return weights;
}

std::array<Vec3, 8> hexahedron_slopes(const Vec3& p) {
  std::array<Vec3, 8> slopes;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto [cx, cy, cz] = corners[i];
    const double x = cx ? p.x : 1 - p.x, y = cy ? p.y : 1 - p.y, z = cz ? p.z : 1 - p.z;
    slopes[i] = {(cx ? 1 : -1) * y * z, x * (cy ? 1 : -1) * z, x * y * (cz ? 1 : -1)};
  }
  return slopes;
}

}  // namespace pellucid::fields
