// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Two counter-rotating gyres whose common border swings: S. C. Shadden, F. Lekien, J. E. Marsden,
// "Definition and properties of Lagrangian coherent structures", Physica D 212 (2005), Sect. 6:
//   stream function A sin(πf) sin(πy), f = ε sin(ωt) x² + (1 - 2ε sin(ωt)) x on [0, 2] × [0, 1].
// Made three-dimensional by a constant drift along z, which keeps it free of divergence.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// DoubleGyreOptions are the constants of the field `double-gyre`.
struct DoubleGyreOptions {
  double A = 0.1;              // world units²/time: strength
  double eps = 0.25;           // world units: amplitude of swing
  double omega = 2 * pi / 10;  // rad/time: of the swing
  double c = 0.1;              // world units/time: drift along z
};

/// A DoubleGyre is the field `double-gyre`: double gyre with drift.
struct DoubleGyre : DoubleGyreOptions {
  using Options = DoubleGyreOptions;
  static constexpr FlowFacts facts{
      .name = "double-gyre",
      .title = "Double gyre with drift",
      .citation = "Shadden, Lekien, Marsden, Physica D 212 (2005)",
      .formula =
          "(-pi A sin(pi f) cos(pi y), pi A cos(pi f) sin(pi y) f', c), "
          "f = eps sin(omega t) x^2 + (1 - 2 eps sin(omega t)) x",
      .steady = false,
      .divergence_free = true,
      .region = {Vec3(0), Vec3(2, 1, 1)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("A", &Options::A, {.unit = "world units²/time", .help = "strength"}),
        number("eps", &Options::eps, {.unit = "world units", .help = "amplitude of swing"}),
        number("omega", &Options::omega, {.unit = "rad/time", .help = "2π/10 by default"}),
        number("c", &Options::c, {.unit = "world units/time", .help = "drift along z"})};
    return table;
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const double a = eps * sin(omega * t), b = 1 - 2 * a;
    const T f = (a * p.x + b) * p.x;
    const T slope = 2 * a * p.x + b;
    return {-pi * A * sin(pi * f) * cos(pi * p.y), pi * A * cos(pi * f) * sin(pi * p.y) * slope,
            T(c)};
  }
};

}  // namespace pellucid::fields::flow
