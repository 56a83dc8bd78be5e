// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A planar saddle: particles go (x exp at, y exp -at, z), and xy is kept. The plane x = 0 separates
// two families of stream lines.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

struct Saddle {
  static constexpr FlowFacts facts{
      .name = "saddle",
      .title = "Saddle",
      .citation = "closed form: (x exp(at), y exp(-at), z)",
      .formula = "(a x, -a y, 0)",
      .divergence_free = true,
  };
  static constexpr ParameterSpec parameters[] = {
      {.name = "a", .default_value = "1", .unit = "1/time", .help = "rate of stretching"},
  };

  double a;

  explicit Saddle(const Parameters& p) : a(p.real("a")) {}

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double) const {
    return {a * p.x, -a * p.y, T(0)};
  }
};

}  // namespace pellucid::fields::flow
