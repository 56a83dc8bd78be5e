// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rigid rotation about the z axis with a constant drift along it. The stream surface of a radial
// segment is a helicoid: (r cos ωt, r sin ωt, ct).

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// RotationOptions are the constants of the field `rotation`.
struct RotationOptions {
  double omega = 1;  // rad/time: angular velocity
  double c = 0.2;    // world units/time: drift along z
};

/// A Rotation is the field `rotation`: rigid rotation and translation.
struct Rotation : RotationOptions {
  using Options = RotationOptions;
  static constexpr FlowFacts facts{
      .name = "rotation",
      .title = "Rigid rotation and translation",
      .citation = "closed form: helices (r cos ωt, r sin ωt, ct)",
      .formula = "(-omega y, omega x, c)",
      .divergence_free = true,
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("omega", &Options::omega, {.unit = "rad/time", .help = "angular velocity"}),
        number("c", &Options::c, {.unit = "world units/time", .help = "drift along z"})};
    return table;
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {-omega * p.y, omega * p.x, T(c)};
  }
};

}  // namespace pellucid::fields::flow
