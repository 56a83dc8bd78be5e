// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A saddle whose stretching turns to compression and back: particles go (x exp(sin t),
// y exp(-sin t), z), and xy is kept.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// A PulsingSaddle is the field `pulsing-saddle`: pulsing saddle.
struct PulsingSaddle : WithoutOptions {
  static constexpr FlowFacts facts{
      .name = "pulsing-saddle",
      .title = "Pulsing saddle",
      .citation = "closed form: (x exp(sin t), y exp(-sin t), z)",
      .formula = "(x cos t, -y cos t, 0)",
      .steady = false,
      .divergence_free = true,
  };

  template <class T>
  Triple<T> operator()(const Triple<T>& p, double t) const {
    const double rate = cos(t);
    return {rate * p.x, -rate * p.y, T(0)};
  }
};

}  // namespace pellucid::fields::flow
