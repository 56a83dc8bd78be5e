// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Linear shear: particles go (x + (y + b)t, y, z). Fronts slant without bound.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// ShearOptions are the constants of the field `shear`.
struct ShearOptions {
  double b = 1;  // world units/time: speed at y = 0
};

/// A Shear is the field `shear`: linear shear.
struct Shear : ShearOptions {
  using Options = ShearOptions;
  static constexpr FlowFacts facts{
      .name = "shear",
      .title = "Linear shear",
      .citation = "closed form: (x + (y + b) t, y, z)",
      .formula = "(y + b, 0, 0)",
      .divergence_free = true,
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("b", &Options::b, {.unit = "world units/time", .help = "speed at y = 0"})};
    return table;
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {p.y + b, T(0), T(0)};
  }
};

}  // namespace pellucid::fields::flow
