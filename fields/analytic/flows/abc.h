// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The Arnold-Beltrami-Childress flow, an exact steady solution of Euler's equations with chaotic
// stream lines: T. Dombre, U. Frisch, J. M. Greene, M. Hénon, A. Mehr, A. M. Soward, "Chaotic
// streamlines in the ABC flows", J. Fluid Mech. 167 (1986), Eq. 1.1. A = √3, B = √2, C = 1 is the
// case that flow visualization uses (G. Haller, "An objective definition of a vortex", J. Fluid
// Mech. 525 (2005)).
//
// Decay in time: curl v = v and div v = 0, hence ∇²v = -v, and v exp(-νt) solves the Navier-Stokes
// equations of viscosity ν without forcing (the non-linear term is the gradient of |v|²/2). The
// parameter `decay` is that ν.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// AbcOptions are the constants of the field `abc`.
struct AbcOptions {
  double A = std::numbers::sqrt3;
  double B = std::numbers::sqrt2;
  double C = 1;      // 0 makes the flow integrable
  double decay = 0;  // 1/time: viscosity
};

/// An Abc is the field `abc`: Arnold-Beltrami-Childress flow.
struct Abc : AbcOptions {
  using Options = AbcOptions;
  static constexpr FlowFacts facts{
      .name = "abc",
      .title = "Arnold-Beltrami-Childress flow",
      .citation = "Dombre et al., J. Fluid Mech. 167 (1986), Eq. 1.1",
      .formula = "(A sin z + C cos y, B sin x + A cos z, C sin y + B cos x) exp(-decay t)",
      .divergence_free = true,
      .region = {Vec3(0), Vec3(2 * pi)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("A", &Options::A, {.unit = "1", .help = "√3 by default"}),
        number("B", &Options::B, {.unit = "1", .help = "√2 by default"}),
        number("C", &Options::C, {.unit = "1", .help = "0 makes the flow integrable"}),
        number("decay", &Options::decay, {.min = 0, .unit = "1/time", .help = "viscosity"})};
    return table;
  }

  bool steady() const { return decay == 0; }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const double scale = decay == 0 ? 1 : std::exp(-decay * t);
    return {scale * (A * sin(p.z) + C * cos(p.y)), scale * (B * sin(p.x) + A * cos(p.z)),
            scale * (C * sin(p.y) + B * cos(p.x))};
  }
};

}  // namespace pellucid::fields::flow
