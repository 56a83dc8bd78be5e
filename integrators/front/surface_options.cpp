// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_options.h"

namespace pellucid::integrators {

const OptionTable<SurfaceOptions>& surface_options() {
  using Options = SurfaceOptions;
  static const OptionTable<Options> table{
      choice("normals", &Options::normals,
             {{"variational", SurfaceNormals::variational},
              {"ghost", SurfaceNormals::ghost},
              {"none", SurfaceNormals::none}},
             "∂x/∂s by the variational equation, by a ghost particle, or not at all"),
      choice("ghost", &Options::ghost,
             {{"reset", GhostControl::reset}, {"rescale", GhostControl::rescale}},
             "pull the ghost back when it is too far, or after every step"),
      number("rip", &Options::rip,
             {.min = 1e-12,
              .max = 0.5,
              .unit = "1",
              .help = "neighbours that part are torn once their seeds are so close, in s"}),
      number("max-particles", &Options::max_particles,
             {.min = 2,
              .max = 1e9,
              .unit = "particles",
              .help = "the surface is not refined any more"}),
      number("max-triangles", &Options::max_triangles,
             {.min = 1, .max = 1e9, .unit = "triangles", .help = "the surface ends"}),
      part(&Options::stepping, stepping_options())};
  return table;
}

}  // namespace pellucid::integrators
