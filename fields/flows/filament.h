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

#include <vector>

#include "fields/analytic_field.h"

namespace pellucid::flow {

struct FilamentElement {
  Vec3 position;
  Vec3 length;  // dl, a step along the filament
};

template <class T>
struct FilamentSums {
  Triple<T> around{T(0), T(0), T(0)};
  Triple<T> along{T(0), T(0), T(0)};
};

template <class T>
FilamentSums<T> sum_over(const std::vector<FilamentElement>& filament, const Triple<T>& p,
                         double core) {
  FilamentSums<T> sums;
  for (const auto& [at, dl] : filament) {
    const T x = p.x - at.x, y = p.y - at.y, z = p.z - at.z;
    const T d2 = x * x + y * y + z * z + core * core;
    const T cubed = 1.0 / (d2 * sqrt(d2));
    sums.around.x = sums.around.x + cubed * (dl.y * z - dl.z * y);
    sums.around.y = sums.around.y + cubed * (dl.z * x - dl.x * z);
    sums.around.z = sums.around.z + cubed * (dl.x * y - dl.y * x);
    const T fifth = 3.0 * cubed / d2;
    const T on_axis = core * core * fifth - cubed,
            to_point = fifth * (dl.x * x + dl.y * y + dl.z * z);
    sums.along.x = sums.along.x + on_axis * dl.x + to_point * x;
    sums.along.y = sums.along.y + on_axis * dl.y + to_point * y;
    sums.along.z = sums.along.z + on_axis * dl.z + to_point * z;
  }
  return sums;
}

}  // namespace pellucid::flow
