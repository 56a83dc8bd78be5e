#include "oit/importance_series.h"

#include "oit/energy_block.h"

namespace pellucid {
namespace {

constexpr GLuint coefficients_image = 6;  // of importance_series.glsl

EnergyBlock energy(const Stage& stage, const Parameters& parameters) {
  EnergyBlock block(energy_weights(parameters, stage.scene().energy));
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
    : stage_(stage),
      half_(is_half(parameters)),
      coefficients_(target(stage, parameters)),
      projection_(stage, coefficients_, importance_bands(parameters), parameters,
                  projection_defines(parameters)),
      energy_(energy(stage, parameters).buffer(stage.gl())),
      defines_{{"IMPORTANCE", 1},
               {"IMPORTANCE_BANDS", importance_bands(parameters)},
               {"IMPORTANCE_PRECISION", parameters.integer("precision")},
               {"PIXELS_PER_SERIES", half_ ? 2 : 1}} {}

void ImportanceSeries::project() const {
  if (half_) stage_.halve_resolution(true);
  projection_.project();
  if (half_) stage_.halve_resolution(false);
}

void ImportanceSeries::bind() const {
  EnergyBlock::bind(energy_);
  coefficients_.bind_image(coefficients_image);
}

}  // namespace pellucid
