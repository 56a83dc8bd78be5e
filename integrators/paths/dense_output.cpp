// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/dense_output.h"

#include <cmath>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {

ParticleState DenseOutput::state(double theta) const {
  ParticleState y = coefficients[4];
  for (int n = 3; n >= 0; --n)
    for (int i = 0; i < 6; ++i) y[i] = y[i] * theta + coefficients[n][i];
  return y;
}

Vec3 DenseOutput::position(double theta) const {
  Vec3 x = first(coefficients[4]);
  for (int n = 3; n >= 0; --n) x = x * theta + first(coefficients[n]);
  return x;
}

Vec3 DenseOutput::derivative(double theta) const {
  Vec3 slope = first(coefficients[4]) * 4.0;
  for (int n = 3; n > 0; --n) slope = slope * theta + first(coefficients[n]) * double(n);
  return slope;
}

Vec3 DenseOutput::second_derivative(double theta) const {
  const auto& c = coefficients;
  return 2.0 * first(c[2]) + theta * (6.0 * first(c[3]) + theta * 12.0 * first(c[4]));
}

double DenseOutput::arc_length(double theta) const {
  constexpr int pieces = 16;
  const double half = 0.5 * theta / pieces, node = std::sqrt(0.6) * half;
  const auto speed = [this](double at) { return magnitude(derivative(at)); };
  double length = 0;
  for (int i = 0; i < pieces; ++i) {
    const double middle = (2 * i + 1) * half;
    length += half / 9 * (8 * speed(middle) + 5 * (speed(middle - node) + speed(middle + node)));
  }
  return length;
}

double DenseOutput::theta_of_length(double length) const {
  double low = 0, high = 1;
  for (int i = 0; i < 53; ++i) {
    const double middle = 0.5 * (low + high);
    (arc_length(middle) < length ? low : high) = middle;
  }
  return high;
}

}  // namespace pellucid::integrators
