// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/options/parameters.h"

namespace pellucid::integrators {

/// How particles move; trajectory_options() reads them.
inline constexpr auto stepping_parameters = std::to_array<ParameterSpec>(
    {{.name = "stepper",
      .kind = ParameterSpec::Kind::choice,
      .default_value = "dopri5",
      .choices = "euler|rk4|dopri5",
      .help = "scheme that moves the particles"},
     {.name = "accuracy",
      .kind = ParameterSpec::Kind::real,
      .min = 0,
      .unit = "world units",
      .help = "largest error of one step; default 1e-9 of the seeds' extent"},
     {.name = "dt",
      .kind = ParameterSpec::Kind::real,
      .min = 0,
      .unit = "time",
      .help = "largest time step; euler and rk4 take it, default a 500th of the duration"},
     {.name = "cells",
      .kind = ParameterSpec::Kind::real,
      .min = 0,
      .unit = "cells",
      .help = "largest step in sampled data; default 0.5, or more where no kink is felt"},
     {.name = "length",
      .kind = ParameterSpec::Kind::real,
      .min = 0,
      .unit = "world units",
      .help = "a particle ends when it has gone so far; default: no limit"},
     {.name = "max-steps",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "1000000",
      .min = 1,
      .max = 1e9,
      .unit = "steps",
      .help = "a particle ends after so many"}});

/// A row's own parameters, then those of stepping.
template <std::size_t n>
constexpr auto with_stepping_parameters(const ParameterSpec (&own)[n]) {
  return concatenate(std::to_array(own), stepping_parameters);
}

}  // namespace pellucid::integrators
