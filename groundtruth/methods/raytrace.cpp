// SPDX-License-Identifier: GPL-3.0-or-later
// Ground truth: all crossings of every ray, each once, decided with exact signs, and composited
// front to back in double; see Raytracer.

#include "groundtruth/methods/raytrace.h"

#include "groundtruth/methods/raytracer.h"

namespace pellucid::groundtruth {
namespace {

constexpr ParameterSpec parameters[] = {
    {.name = "precision",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "exact",
     .choices = "exact|double|fast",
     .help =
         "exact: signs of exact arithmetic, each crossing once; double: signs as rounded; fast: "
         "meshes as Embree intersects them, in float: shared edges count twice, or not"},
    stop_below_parameter,
    {.name = "adaptive",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "1",
     .min = 1,
     .max = 64,
     .unit = "samples",
     .help = "n: pixels that differ from a neighbour are traced again with n x n samples; 1: off"},
    {.name = "contrast",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0.01",
     .min = 0,
     .max = 1,
     .help = "with adaptive: pixels differ by more than this in a channel"}};

Precision precision_named(std::string_view name) {
  if (name == "fast") return Precision::fast;
  return name == "double" ? Precision::rounded : Precision::exact;
}

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& values,
                                      const scene::RenderContext&) {
  return make_raytracer(scene, {.precision = precision_named(values.text("precision")),
                                .stop_below = values.real("stop-below"),
                                .adaptive = int(values.integer("adaptive")),
                                .contrast = values.real("contrast")});
}

constexpr scene::MethodRow row{
    .name = "raytrace",
    .title = "Exact composite (ray tracing)",
    .citation =
        "Wald et al., Embree: a kernel framework for efficient CPU ray tracing, "
        "SIGGRAPH 2014; crossings decided by Pellucid",
    .equations = "Baeza Rojo et al. 2019, Eq. 12",
    .parameters = parameters,
    .promises = {.exact = true,
                 .exact_unless = "precision|stop-below|adaptive",
                 .order_independent = true,
                 .convex_hull = true,
                 .draws_isosurfaces = true,
                 .one_layer_unless = "precision=fast",
                 .edge_shift = 0},
    .bytes_per_pixel = "0; 32 per crossing of a packet of 8 rays, and the hierarchy",
    .make = make};

}  // namespace

const scene::MethodRow& raytrace_method() { return row; }

}  // namespace pellucid::groundtruth
