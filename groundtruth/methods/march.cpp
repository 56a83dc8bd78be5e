// SPDX-License-Identifier: GPL-3.0-or-later
// Isosurfaces by front-to-back ray marching with a step of dx / k of the finest cell that takes
// part: Li, Chen, Multi-Resolution Isosurface Rendering (2023), Sect. 3.5; see LevelMarch for what
// differs. Crossings are composited in double as `raytrace` composites them, with all other objects
// of the scene, which are crossed exactly. Depths are view depths, in units (see ViewFrame).
// `filter=dilate:R` is the report's object filter, Sect. 3.6: a march ends where its ray enters an
// opaque sphere grown by R. Erratum kept: rays that enter it and miss the sphere itself lose all
// that lies behind, a ring of background; an isosurface's `hole` cuts the same shell away and no
// more. Accuracy: no bound. Pairs of crossings closer than a step are lost; see the study
// `isosurface`.

#include "groundtruth/methods/march.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "groundtruth/methods/raytracer.h"

namespace pellucid::groundtruth {
namespace {

constexpr ParameterSpec parameters[] = {
    {.name = "step",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "8",
     .min = 1,
     .max = 64,
     .unit = "1/cell",
     .help = "steps across the finest cell that takes part"},
    {.name = "refine",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "linear",
     .choices = "linear|bisection",
     .help = "where between two samples the surface is: on the line through both, or by bisection"},
    {.name = "skip",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "blocks",
     .choices = "blocks|none",
     .help = "blocks: pass over 4 x 4 x 4 cells without the value; the picture stays the same"},
    {.name = "filter",
     .kind = ParameterSpec::Kind::text,
     .default_value = "none",
     .unit = "world units",
     .help = "none, or dilate:R: rays end at opaque spheres grown by R, even where they miss them"},
    stop_below_parameter};

std::optional<double> dilation(const std::string& filter) {
  constexpr std::string_view prefix = "dilate:";
  double by = 0;
  if (filter == "none") return std::nullopt;
  if (!filter.starts_with(prefix) || !parse_number(filter.substr(prefix.size()), by) ||
      !(by >= 0) || !std::isfinite(by))
    throw InputError(
        fmt::format("march: filter={}; accepted: none, dilate:R with R at least 0", filter));
  return by;
}

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& values,
                                      const scene::RenderContext&) {
  TraceOptions options;
  options.stop_below = values.real("stop-below");
  options.march = {
      double(values.integer("step")),
      values.text("refine") == "linear" ? HitRefinement::linear : HitRefinement::bisection,
      options.stop_below, values.text("skip") == "blocks", dilation(values.text("filter"))};
  return make_raytracer(scene, options);
}

constexpr scene::MethodRow row{
    .name = "march",
    .title = "Ray marching of isosurfaces",
    .citation = "Li, Chen, Multi-Resolution Isosurface Rendering, 2023",
    .equations = "Sect. 3.5, with Eqs. 2, 3",
    .parameters = parameters,
    .promises = {.exact_without_isosurfaces = true,
                 .exact_unless = "stop-below|filter",
                 .order_independent = true,
                 .convex_hull = true,
                 .draws_isosurfaces = true,
                 .edge_shift = 0},
    .bytes_per_pixel = "0; 32 per crossing of a packet of 8 rays, a byte per 64 cells",
    .sweep = "step=2|8|16",
    .make = make};

}  // namespace

const scene::MethodRow& march_method() { return row; }

}  // namespace pellucid::groundtruth
