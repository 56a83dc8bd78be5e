// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hill's spherical vortex, in the frame that moves with it: M. J. M. Hill, "On a spherical vortex",
// Phil. Trans. R. Soc. A 185 (1894); P. G. Saffman, Vortex Dynamics (1992), Sect. 2.1. With
// ρ² = x² + y² and r² = ρ² + z² the Stokes stream function, which stream lines keep, is
//   ψ = ½ U ρ² (1 - a³/r³) outside,   ψ = -¾ U ρ² (1 - r²/a²) inside,
// and the velocity u_z = ∂ψ/∂ρ / ρ, u_ρ = -∂ψ/∂z / ρ; both are continuous on the sphere r = a,
// where the vorticity jumps.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// HillOptions are the constants of the field `hill`.
struct HillOptions {
  double U = 1;  // world units/time: speed far away
  double a = 1;  // world units: radius
};

/// A Hill is the field `hill`: Hill's spherical vortex.
struct Hill : HillOptions {
  using Options = HillOptions;
  static constexpr FlowFacts facts{
      .name = "hill",
      .title = "Hill's spherical vortex",
      .citation = "Hill, Phil. Trans. R. Soc. A 185 (1894)",
      .formula =
          "Stokes stream function U/2 rho^2 (1 - a^3/r^3) outside r = a, "
          "-3U/4 rho^2 (1 - r^2/a^2) inside",
      .divergence_free = true,
      .region = {Vec3(-2), Vec3(2)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("U", &Options::U, {.unit = "world units/time", .help = "speed far away"}),
        number("a", &Options::a, {.min = 1e-300, .unit = "world units", .help = "radius"})};
    return table;
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    const T x = p.x / a, y = p.y / a, z = p.z / a;
    const T rho2 = x * x + y * y, r2 = rho2 + z * z;
    if (r2 < T(1.0)) return {-1.5 * U * x * z, -1.5 * U * y * z, 1.5 * U * (rho2 + r2 - 1.0)};
    const T r3 = r2 * sqrt(r2), r5 = r3 * r2;
    return {-1.5 * U * x * z / r5, -1.5 * U * y * z / r5, U * (1.0 - 1.0 / r3 + 1.5 * rho2 / r5)};
  }
};

}  // namespace pellucid::fields::flow
