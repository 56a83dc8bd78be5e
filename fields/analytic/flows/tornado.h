// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The synthetic tornado of Roger A. Crawfis, The Ohio State University: `gen_tornado` in
// tornadoSrc.c, published on his data page and used by most of the field since. The names are his.
// The unit cube is the published domain; t is his integer `time`, continued to the reals.
//
// Two of its features matter to whoever integrates it: where |r - ρ| passes r2 the factor jumps
// from 1 to 0.8 - r2 (his comment there: "I do not like this next line. It produces a discontinuity
// in the magnitude"), and z0 has a kink where the funnel's updraught ends. He computed in float;
// here it is double, which differs by rounding alone.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// A Tornado is the field `tornado`: Crawfis tornado.
struct Tornado : WithoutOptions {
  static constexpr FlowFacts facts{
      .name = "tornado",
      .title = "Crawfis tornado",
      .citation = "R. A. Crawfis, tornadoSrc.c, The Ohio State University",
      .formula =
          "(s (y - yc) + 0.1 (x - xc), -s (x - xc) + 0.1 (y - yc), s z0), "
          "a funnel about (xc, yc) = 0.5 + 0.1 (sin(0.04t + 10z), cos(0.03t + 3z))",
      .steady = false,
      .region = {Vec3(0), Vec3(1)},
      .bounded = true,
  };

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const T& z = p.z;
    const T dx = p.x - (0.5 + 0.1 * sin(0.04 * t + 10.0 * z));
    const T dy = p.y - (0.5 + 0.1 * cos(0.03 * t + 3.0 * z));
    const T r = 0.1 + 0.4 * z * z + 0.1 * z * sin(8.0 * z);  // the funnel's radius
    const T r2 = 0.2 + 0.1 * z;                              // width of its wall
    const T rho = sqrt(dy * dy + dx * dx);
    const T from_wall = abs(r - rho);
    const T damping = from_wall > r2 ? 0.8 - from_wall : T(1.0);
    const T lift = 0.1 * (0.1 - rho * z);
    const T z0 = lift < 0.0 ? T(0.0) : lift;
    const T distance = sqrt(rho * rho + z0 * z0);
    const T s = (r + r2 - distance) * damping / (distance + 1e-11) / (1.0 + z);
    return {s * dy + 0.1 * dx, -s * dx + 0.1 * dy, s * z0};
  }
};

}  // namespace pellucid::fields::flow
