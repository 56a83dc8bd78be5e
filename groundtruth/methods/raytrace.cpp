// SPDX-License-Identifier: GPL-3.0-or-later
// Ground truth: all crossings of every ray, each once, decided with exact signs, and composited
// front to back in double; see Raytracer.

#include "groundtruth/methods/raytrace.h"

namespace pellucid::groundtruth {
namespace {

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& values,
                                      const scene::RenderContext&) {
  return make_raytracer(scene, raytrace_options().read(values));
}

}  // namespace

const OptionTable<RaytraceOptions>& raytrace_options() {
  static const OptionTable<RaytraceOptions> table{
      choice(
          "precision", &RaytraceOptions::precision,
          {{"exact", Precision::exact}, {"double", Precision::rounded}, {"fast", Precision::fast}},
          "exact: signs of exact arithmetic, each crossing once; double: signs as rounded; "
          "fast: meshes as Embree intersects them, in float: shared edges count twice, or not"),
      stop_below_option(&RaytraceOptions::stop_below),
      number("adaptive", &RaytraceOptions::adaptive,
             {.min = 1,
              .max = 64,
              .unit = "samples",
              .help = "n: pixels that differ from a neighbour are traced again with n x n samples; "
                      "1: off"}),
      number("contrast", &RaytraceOptions::contrast,
             {.min = 0,
              .max = 1,
              .help = "with adaptive: pixels differ by more than this in a channel"})};
  return table;
}

const scene::MethodRow& raytrace_method() {
  static const scene::MethodRow row{
      .name = "raytrace",
      .title = "Exact composite (ray tracing)",
      .citation =
          "Wald et al., Embree: a kernel framework for efficient CPU ray tracing, "
          "SIGGRAPH 2014; crossings decided by Pellucid",
      .equations = "Baeza Rojo et al. 2019, Eq. 12",
      .checked_against = "the paper of Eq. 12; crossings against an exact kernel of CGAL's",
      .parameters = raytrace_options().specs(),
      .promises = {.exact = true,
                   .exact_unless = "precision|stop-below|adaptive",
                   .order_independent = true,
                   .convex_hull = true,
                   .in_double = true,
                   .one_layer_unless = "precision=fast",
                   .edge_shift = 0},
      .bytes_per_pixel = "0; 32 per crossing of a packet of 8 rays, and the hierarchy",
      .sweep = "precision=exact|fast,stop-below=0|0.01",
      .make = make};
  return row;
}

}  // namespace pellucid::groundtruth
