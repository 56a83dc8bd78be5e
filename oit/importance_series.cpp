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

Texture target(Stage& stage, const Parameters& parameters) {
  const FourierTarget target = fourier_target(importance_bands(parameters), parameters);
  return stage.target("Fourier coefficients of the importance", target.format, target.layers);
}

}  // namespace

ImportanceSeries::ImportanceSeries(Stage& stage, const Parameters& parameters)
    : coefficients_(target(stage, parameters)),
      projection_(stage, coefficients_, importance_bands(parameters), parameters,
                  {{"IMPORTANCE", 1}, {"PROJECT_IMPORTANCE", 1}}),
      energy_(energy(stage, parameters).buffer(stage.gl())),
      defines_{{"IMPORTANCE", 1},
               {"IMPORTANCE_BANDS", importance_bands(parameters)},
               {"IMPORTANCE_PRECISION", parameters.integer("precision")}} {}

void ImportanceSeries::bind() const {
  EnergyBlock::bind(energy_);
  coefficients_.bind_image(coefficients_image);
}

}  // namespace pellucid
