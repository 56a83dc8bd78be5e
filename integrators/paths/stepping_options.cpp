// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/stepping_options.h"

namespace pellucid::integrators {

const OptionTable<SteppingOptions>& stepping_options() {
  using Options = SteppingOptions;
  static const OptionTable<Options> table{
      choice("stepper", &Options::stepper, steppers(), "scheme that moves the particles"),
      number("accuracy", &Options::accuracy,
             {.min = 0,
              .unit = "world units",
              .help = "largest error of one step; default 1e-9 of the seeds' extent, for a single "
                      "seed of the field's domain or, without one, of the length over which its "
                      "velocity changes; in samples no less than a tenth of their error"}),
      number("dt", &Options::dt,
             {.min = 0,
              .unit = "time",
              .help = "largest time step; euler and rk4 take it, default a 500th of the duration; "
                      "dopri5 where the field's time runs along: a 50th, or from frame to frame"}),
      number("cells", &Options::cells,
             {.min = 0,
              .unit = "cells",
              .help = "largest step in sampled data; default 0.5, or more where no kink is felt"}),
      number("length", &Options::length,
             {.min = 0,
              .unit = "world units",
              .help = "a particle ends when it has gone so far; default: no limit"}),
      number("max-steps", &Options::max_steps,
             {.min = 1, .max = 1e9, .unit = "steps", .help = "a particle ends after so many"})};
  return table;
}

}  // namespace pellucid::integrators
