// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_options.h"

namespace pellucid::integrators {

const OptionTable<SheetOptions>& sheet_options() {
  using Options = SheetOptions;
  static const OptionTable<Options> table{
      number("tolerance", &Options::tolerance,
             {.min = 0,
              .unit = "world units",
              .help = "largest distance between mesh and surface; default: 1e-3 of the seeds' "
                      "extent"}),
      number("particles", &Options::particles,
             {.min = 2,
              .max = 10'000,
              .unit = "particles",
              .help = "along each side of the seeds, before any is added: what is smaller may be "
                      "missed"}),
      number("rip", &Options::rip,
             {.min = 1e-12,
              .max = 0.5,
              .unit = "1",
              .help = "sides so short on the seeds are not halved: what tears end in is left out"}),
      number(
          "max-particles", &Options::max_particles,
          {.min = 3, .max = 1e9, .unit = "particles", .help = "the sheet is not refined any more"}),
      number(
          "max-triangles", &Options::max_triangles,
          {.min = 1, .max = 1e9, .unit = "triangles", .help = "the sheet is not refined any more"}),
      part(&Options::stepping, stepping_options())};
  return table;
}

}  // namespace pellucid::integrators
