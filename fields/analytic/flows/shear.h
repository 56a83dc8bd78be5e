// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Linear shear: particles go (x + (y + b)t, y, z). Fronts slant without bound.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

struct Shear {
  static constexpr FlowFacts facts{
      .name = "shear",
      .title = "Linear shear",
      .citation = "closed form: (x + (y + b) t, y, z)",
      .formula = "(y + b, 0, 0)",
      .divergence_free = true,
  };
  static constexpr ParameterSpec parameters[] = {
      {.name = "b", .default_value = "1", .unit = "world units/time", .help = "speed at y = 0"},
  };

  double b;

  explicit Shear(const Parameters& p) : b(p.real("b")) {}

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {p.y + b, T(0), T(0)};
  }
};

}  // namespace pellucid::fields::flow
