// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Velocity induced by vortex filaments, or the magnetic field of a current along them.
//
// With elements dl_i at x_i, r = x - x_i, Rosenhead's core ε (L. Rosenhead, Proc. R. Soc. A 127
// (1930)) and s = sqrt(r² + ε²), the vector potential A = Σ dl_i / s has the curl
//   around = Σ dl_i × r / s³,
// and the curl of that, the smoothed current itself, is
//   along = Σ dl_i (3ε²/s⁵ - 1/s³) + 3 (dl_i · r) r / s⁵.
// Both are free of divergence for any elements. Over a closed curve the terms of `along` without ε
// add up to nothing, and it is 4π times a tube of unit flux whose profile is 3ε²/4πs⁵.

#include <cmath>
#include <glm/matrix.hpp>
#include <vector>

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// A FilamentElement is a short straight piece of a vortex filament.
struct FilamentElement {
  Vec3 position;
  Vec3 length;  // dl, a step along the filament
};

/// FilamentSums are the sums over a filament's elements that a velocity is made of, each a vector.
template <class T>
struct FilamentSums {
  Triple<T> around{T(0), T(0), T(0)};
  Triple<T> along{T(0), T(0), T(0)};
};

/// Returns the sums at the point p; `core` is the radius within which the filament is smooth.
inline FilamentSums<double> sum_over(const std::vector<FilamentElement>& filament,
                                     const Triple<double>& p, double core) {
  const Vec3 place(p.x, p.y, p.z);
  Vec3 around(0), along(0);
  for (const auto& [at, dl] : filament) {
    const Vec3 r = place - at;
    const double i1 = 1 / std::sqrt(glm::dot(r, r) + core * core), i3 = i1 * i1 * i1;
    const double i5 = i3 * i1 * i1;
    around += i3 * glm::cross(dl, r);
    along += (3 * core * core * i5 - i3) * dl + 3 * glm::dot(dl, r) * i5 * r;
  }
  return {{around.x, around.y, around.z}, {along.x, along.y, along.z}};
}

/// Returns the sums with their derivatives, by closed forms: half the cost of Duals in the loop.
///   ∂around/∂r_j = Σ dl × e_j / s³ - 3 r_j dl × r / s⁵
///   ∂along/∂r_j  = Σ dl r_j (3/s⁵ - 15ε²/s⁷) + 3 (dl_j r + (dl · r) e_j)/s⁵ - 15 (dl · r) r_j r /
///   s⁷
inline FilamentSums<Dual> sum_over(const std::vector<FilamentElement>& filament,
                                   const Triple<Dual>& p, double core) {
  const Vec3 place(p.x.value, p.y.value, p.z.value);
  Vec3 around(0), along(0), current(0);
  Mat3 around_by(0), along_by(0);
  for (const auto& [at, dl] : filament) {
    const Vec3 r = place - at, c = glm::cross(dl, r);
    const double q = glm::dot(dl, r), i1 = 1 / std::sqrt(glm::dot(r, r) + core * core);
    const double i3 = i1 * i1 * i1, i5 = i3 * i1 * i1, i7 = i5 * i1 * i1;
    around += i3 * c;
    current += i3 * dl;
    around_by += glm::outerProduct(-3 * i5 * c, r);
    along += (3 * core * core * i5 - i3) * dl + 3 * q * i5 * r;
    along_by += glm::outerProduct((3 * i5 - 15 * core * core * i7) * dl - 15 * q * i7 * r, r) +
                glm::outerProduct(3 * i5 * r, dl) + Mat3(3 * i5 * q);
  }
  for (int j = 0; j < 3; ++j) around_by[j] += glm::cross(current, Mat3(1)[j]);
  const Mat3 place_by = glm::transpose(Mat3(p.x.gradient, p.y.gradient, p.z.gradient));
  const auto with_gradients = [&](const Vec3& sum, const Mat3& by) {
    const Mat3 rows = glm::transpose(by * place_by);
    return Triple<Dual>{{sum.x, rows[0]}, {sum.y, rows[1]}, {sum.z, rows[2]}};
  };
  return {with_gradients(around, around_by), with_gradients(along, along_by)};
}

}  // namespace pellucid::fields::flow
