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

namespace pellucid::groundtruth {
namespace {

std::string dilation_text(const std::optional<double>& dilate) {
  return dilate ? "dilate:" + number_text(*dilate) : "none";
}

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

const OptionTable<MarchOptions>& level_march_options() {
  static const OptionTable<MarchOptions> table{
      number("step", &MarchOptions::steps_per_cell,
             {.min = 1,
              .max = 64,
              .unit = "1/cell",
              .help = "steps across the finest cell that takes part",
              .whole = true}),
      choice(
          "refine", &MarchOptions::refinement,
          {{"linear", HitRefinement::linear},
           {"bisection", HitRefinement::bisection},
           {"sample", HitRefinement::sample}},
          "where between two samples the surface is: on the line through both, by bisection, or, "
          "as in the report, at the first sample inside; ways out do not count then"),
      choice("skip", &MarchOptions::skip_empty, {{"blocks", true}, {"none", false}},
             "blocks: pass over blocks and cells without the value; the picture stays the same"),
      written("filter", &MarchOptions::dilate, dilation_text, dilation,
              "none, or dilate:R: rays end at opaque spheres grown by R, even where they miss them",
              "world units")};
  return table;
}

std::unique_ptr<scene::Renderer> make(const scene::Scene& scene, const Parameters& values,
                                      const scene::RenderContext&) {
  const MarchMethodOptions options = march_options().read(values);
  return make_raytracer(scene, {.stop_below = options.stop_below}, options.march);
}

}  // namespace

const OptionTable<MarchMethodOptions>& march_options() {
  static const OptionTable<MarchMethodOptions> table{
      part(&MarchMethodOptions::march, level_march_options()),
      stop_below_option(&MarchMethodOptions::stop_below)};
  return table;
}

const scene::MethodRow& march_method() {
  static const scene::MethodRow row{
      .name = "march",
      .title = "Ray marching of isosurfaces",
      .citation = "Li, Chen, Multi-Resolution Isosurface Rendering, 2023",
      .equations = "Sect. 3.5, with Eqs. 2, 3",
      .checked_against = "the report",
      .parameters = march_options().specs(),
      .promises = {.exact_without_isosurfaces = true,
                   .exact_unless = "stop-below|filter",
                   .order_independent = true,
                   .convex_hull = true,
                   .in_double = true,
                   .edge_shift = 0},
      .bytes_per_pixel = "0; 32 per crossing of a packet of 8 rays, a bit per cell",
      .sweep = "step=2|8|16",
      .make = make};
  return row;
}

}  // namespace pellucid::groundtruth
