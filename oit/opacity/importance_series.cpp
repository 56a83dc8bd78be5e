// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/opacity/importance_series.h"

#include "oit/gl/bindings.h"
#include "oit/opacity/energy_block.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

EnergyBlock energy(const Stage& stage, const Parameters& parameters) {
  EnergyBlock block(scene::energy_weights(parameters, stage.scene().energy));
  block.margin = float(parameters.real("margin"));
  block.own_share = parameters.text("at") == "middle" ? 0.5f : 1.0f;
  return block;
}

int importance_bands(const Parameters& parameters) {
  const int bands = parameters.integer("importance-bands");
  return bands ? bands : parameters.integer("bands");
}

bool is_half(const Parameters& parameters) {
  return parameters.text("importance-resolution") == "half";
}

Texture target(Stage& stage, const Parameters& parameters) {
  constexpr const char* name = "Fourier coefficients of the importance";
  const auto [format, layers] = fourier_target(importance_bands(parameters), parameters);
  return is_half(parameters) ? stage.half_target(name, format, layers)
                             : stage.target(name, format, layers);
}

Defines projection_defines(const Parameters& parameters) {
  Defines defines{{"IMPORTANCE", 1}, {"PROJECT_IMPORTANCE", 1}};
  if (is_half(parameters)) defines.emplace_back("HALF_RESOLUTION", 1);
  return defines;
}

}  // namespace

ImportanceSeries::ImportanceSeries(Stage& stage, const Parameters& parameters)
    : coefficients_(target(stage, parameters)),
      projection_(stage, coefficients_, importance_bands(parameters), parameters,
                  projection_defines(parameters)),
      energy_(energy(stage, parameters).buffer(stage.gl())),
      defines_{{"IMPORTANCE", 1},
               {"IMPORTANCE_BANDS", importance_bands(parameters)},
               {"IMPORTANCE_PRECISION", parameters.integer("precision")},
               {"PIXELS_PER_SERIES", is_half(parameters) ? 2 : 1}} {}

void ImportanceSeries::project() const { projection_.project(); }

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
