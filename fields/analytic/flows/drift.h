// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A uniform velocity that turns: every particle goes on a unit circle, (sin t, 1 - cos t, 0) from
// its seed. All stream lines are straight: it tells path surfaces from stream surfaces.

#include "fields/analytic/analytic_field.h"

namespace pellucid::fields::flow {

/// A Drift is the field `drift`: turning uniform flow.
struct Drift : WithoutOptions {
  static constexpr FlowFacts facts{
      .name = "drift",
      .title = "Turning uniform flow",
      .citation = "closed form: x + (sin t, 1 - cos t, 0)",
      .formula = "(cos t, sin t, 0)",
      .steady = false,
      .divergence_free = true,
  };

  template <class T>
  Triple<T> operator()(const Triple<T>&, double t) const {
    return {T(cos(t)), T(sin(t)), T(0)};
  }
};

}  // namespace pellucid::fields::flow
