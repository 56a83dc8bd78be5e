// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A shear layer rolled up into a row of vortices, the end of its Kelvin-Helmholtz instability: the
// exact steady solution of Euler's equations by J. T. Stuart, "On finite amplitude oscillations in
// laminar mixing layers", J. Fluid Mech. 29 (1967), with the stream function
//   ψ = ln(c cosh y + sqrt(c² - 1) cos x),
// a tanh profile for c = 1 and a row of point vortices for c → ∞. Written over sech y, so that it
// does not overflow. Made three-dimensional by a constant drift along z.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// KelvinHelmholtzOptions are the constants of the field `kelvin-helmholtz`.
struct KelvinHelmholtzOptions {
  double c = 1.25;      // 1: not rolled up
  double drift = 0.25;  // world units/time: along z
};

/// A KelvinHelmholtz is the field `kelvin-helmholtz`: Kelvin-Helmholtz shear layer (Stuart's
/// vortices).
struct KelvinHelmholtz {
  using Options = KelvinHelmholtzOptions;
  static constexpr FlowFacts facts{
      .name = "kelvin-helmholtz",
      .title = "Kelvin-Helmholtz shear layer (Stuart's vortices)",
      .citation = "Stuart, J. Fluid Mech. 29 (1967)",
      .formula = "(c sinh y / q, k sin x / q, drift), q = c cosh y + k cos x, k = sqrt(c^2 - 1)",
      .divergence_free = true,
      .region = {Vec3(0, -4, 0), Vec3(4 * pi, 4, 4)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("c", &Options::c, {.min = 1, .unit = "1", .help = "1: not rolled up"}),
        number("drift", &Options::drift, {.unit = "world units/time", .help = "along z"})};
    return table;
  }

  double c, k, drift;

  explicit KelvinHelmholtz(const KelvinHelmholtzOptions& given)
      : c(given.c), k(std::sqrt(c * c - 1)), drift(given.drift) {}

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    const T e = exp(-abs(p.y));
    const T sech = 2.0 * e / (1.0 + e * e);
    const T q = c + k * cos(p.x) * sech;
    return {c * tanh(p.y) / q, k * sin(p.x) * sech / q, T(drift)};
  }
};

}  // namespace pellucid::fields::flow
