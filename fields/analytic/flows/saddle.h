// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A planar saddle: particles go (x exp at, y exp -at, z), and xy is kept. The plane x = 0 separates
// two families of stream lines.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// SaddleOptions are the constants of the field `saddle`.
struct SaddleOptions {
  double a = 1;  // 1/time: rate of stretching
};

/// A Saddle is the field `saddle`: saddle.
struct Saddle : SaddleOptions {
  using Options = SaddleOptions;
  static constexpr FlowFacts facts{
      .name = "saddle",
      .title = "Saddle",
      .citation = "closed form: (x exp(at), y exp(-at), z)",
      .formula = "(a x, -a y, 0)",
      .divergence_free = true,
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        number("a", &Options::a, {.unit = "1/time", .help = "rate of stretching"})};
    return table;
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {a * p.x, -a * p.y, T(0)};
  }
};

}  // namespace pellucid::fields::flow
