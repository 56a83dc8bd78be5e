// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Slow flow past a sphere with its wake: H. Lamb's solution of Oseen's equations (Phil. Mag. 21
// (1911)), as in G. K. Batchelor, An Introduction to Fluid Dynamics (1967), Sect. 4.10. With the
// stream U along x, θ measured from x (downstream), k = Re/4a and Re = 2aU/ν, the stream function
// is
//   ψ = U a² [ ¼ (2r²/a² + a/r) sin²θ - 3/Re (1 + cos θ)(1 - exp(-k r (1 - cos θ))) ].
// Its derivatives, with E = exp(-k (r - x)) and ρ² = y² + z²:
//   u_x = U [ 1 + ¼a³ (2/r³ - 3ρ²/r⁵) - 3a²/Re ( (1 + x/r) kE/r - x (1 - E)/r³ ) ],
//   u_ρ = U ρ [ ¾ a³ x/r⁵ + 3a²/Re ( (1 - E)/r³ - kE/r² ) ].
// For Re → 0 it is Stokes' flow; on the sphere the velocity is of the order of Re, as Oseen's
// equations have it. Inside there is none: particles that come there stagnate.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// SphereOptions are the constants of the field `sphere`.
struct SphereOptions {
  double U = 1;   // world units/time: speed far away
  double a = 1;   // world units: radius
  double Re = 4;  // Reynolds number 2aU/ν
};

/// A Sphere is the field `sphere`: flow past a sphere with its wake.
struct Sphere : SphereOptions {
  using Options = SphereOptions;
  static constexpr FlowFacts facts{
      .name = "sphere",
      .title = "Flow past a sphere with its wake",
      .citation = "Oseen's flow: Lamb, Phil. Mag. 21 (1911); Batchelor (1967), Sect. 4.10",
      .formula =
          "stream function U a^2 [(2r^2/a^2 + a/r) sin^2(theta)/4 - 3/Re (1 + cos theta)"
          "(1 - exp(-Re r (1 - cos theta)/4a))]",
      .divergence_free = true,
      .region = {Vec3(-4, -3, -3), Vec3(10, 3, 3)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("U", &Options::U, {.unit = "world units/time", .help = "speed far away"}),
        number("a", &Options::a, {.min = 1e-3, .unit = "world units", .help = "radius"}),
        number("Re", &Options::Re,
               {.min = 1e-3, .max = 1e3, .unit = "1", .help = "Reynolds number 2aU/ν"})};
    return table;
  }

  /// Lengths are in units of the radius.
  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    const T x = p.x / a, y = p.y / a, z = p.z / a;
    const T rho2 = y * y + z * z, r2 = x * x + rho2;
    if (r2 < T(1.0)) return {T(0), T(0), T(0)};
    const T r = sqrt(r2), r3 = r2 * r, r5 = r3 * r2;
    const double k = Re / 4;
    const T E = exp(-k * (r - x));
    const T ux = 1.0 + 0.25 * (2.0 / r3 - 3.0 * rho2 / r5) -
                 3 / Re * ((1.0 + x / r) * k * E / r - x * (1.0 - E) / r3);
    const T by_rho = 0.75 * x / r5 + 3 / Re * ((1.0 - E) / r3 - k * E / r2);
    return {U * ux, U * y * by_rho, U * z * by_rho};
  }
};

}  // namespace pellucid::fields::flow
