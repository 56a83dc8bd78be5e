// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rigid rotation about the z axis with a constant drift along it. The stream surface of a radial
// segment is a helicoid: (r cos ωt, r sin ωt, ct).

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

struct Rotation {
  static constexpr FlowFacts facts{
      .name = "rotation",
      .title = "Rigid rotation and translation",
      .citation = "closed form: helices (r cos ωt, r sin ωt, ct)",
      .formula = "(-omega y, omega x, c)",
      .divergence_free = true,
  };
  static constexpr ParameterSpec parameters[] = {
      {.name = "omega", .default_value = "1", .unit = "rad/time", .help = "angular velocity"},
      {.name = "c", .default_value = "0.2", .unit = "world units/time", .help = "drift along z"},
  };

  double omega, c;

  explicit Rotation(const Parameters& p) : omega(p.real("omega")), c(p.real("c")) {}

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {-omega * p.y, omega * p.x, T(c)};
  }
};

}  // namespace pellucid::fields::flow
