// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/opacity/importance_series.h"

#include "oit/gl/bindings.h"
#include "oit/opacity/energy_block.h"
#include "oit/optical_depth/series_readback.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

EnergyBlock energy(const scene::EnergyWeights& weights, const SeriesOptions& series) {
  EnergyBlock block(weights);
  block.margin = float(series.margin);
  block.own_share = series.at == SeriesValue::middle ? 0.5f : 1.0f;
  return block;
}

bool is_half(const ImportanceOptions& options) {
  return options.resolution == ImportanceResolution::half;
}

Texture target(Stage& stage, const ImportanceOptions& options, const SeriesOptions& series) {
  constexpr const char* name = "Fourier coefficients of the importance";
  const auto [format, layers] = fourier_target(options.bands, series);
  return is_half(options) ? stage.half_target(name, format, layers)
                          : stage.target(name, format, layers);
}

Defines projection_defines(const ImportanceOptions& options) {
  Defines defines{{"IMPORTANCE", 1}, {"PROJECT_IMPORTANCE", 1}};
  if (is_half(options)) defines.emplace_back("HALF_RESOLUTION", 1);
  return defines;
}

}  // namespace

const OptionTable<ImportanceOptions>& importance_options() {
  static const OptionTable<ImportanceOptions> table{
      number("importance-bands", &ImportanceOptions::bands,
             {.min = 0,
              .max = 64,
              .unit = "bands",
              .help = "of the series of the importance; 0: as many as `bands`, the optical "
                      "depth's"}),
      choice("importance-resolution", &ImportanceOptions::resolution,
             {{"full", ImportanceResolution::full}, {"half", ImportanceResolution::half}},
             "of the importance's series: one a pixel, or one for 2 x 2")};
  return table;
}

ImportanceSeries::ImportanceSeries(Stage& stage, const ImportanceOptions& options,
                                   const SeriesOptions& series, const scene::EnergyWeights& weights)
    : bands_(options.bands),
      margin_(float(series.margin)),
      pixels_per_series_(is_half(options) ? 2 : 1),
      coefficients_(target(stage, options, series)),
      projection_(stage, coefficients_, options.bands, series, projection_defines(options)),
      energy_(energy(weights, series).buffer(stage.gl())),
      defines_{{"IMPORTANCE", 1},
               {"IMPORTANCE_BANDS", options.bands},
               {"IMPORTANCE_PRECISION", series.precision},
               {"PIXELS_PER_SERIES", pixels_per_series_}} {}

void ImportanceSeries::project() const { projection_.project(); }

scene::RaySeries ImportanceSeries::at(int x, int y, std::span<const double> d) const {
  return read_series(coefficients_, bands_, margin_, x / pixels_per_series_, y / pixels_per_series_,
                     d);
}

FragmentOpacity ImportanceSeries::fragment_opacity() const {
  Defines defines = defines_;
  defines.emplace_back("OPTIMIZED_FRAGMENTS", 1);
  return {std::move(defines), oit_glsl::optimized_fragments_glsl(), resources()};
}

Resources ImportanceSeries::resources() const {
  return {energy_.as_uniform_block(bindings::energy_block),
          coefficients_.as_image(bindings::importance_image)};
}

}  // namespace pellucid::oit
