#include "oit/importance_series.h"

#include "scene/opacity_energy.h"

namespace pellucid {
namespace {

// Uniform block and image of importance_series.glsl.
constexpr GLuint energy_block = 1, coefficients_image = 6;

struct Energy {
  glm::vec4 weights;  // p, q, r, lambda
  float margin;
  float own_share;
  glm::vec2 unused{0};
};
static_assert(sizeof(Energy) == 32);

Energy energy(const Parameters& parameters) {
  const EnergyWeights w = energy_weights(parameters);
  return {{w.p, w.q, w.r, w.lambda},
          float(parameters.real("margin")),
          parameters.text("at") == "middle" ? 0.5f : 1.0f};
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
      energy_(stage.gl(), std::vector<Energy>{energy(parameters)}),
      defines_{{"IMPORTANCE", 1},
               {"IMPORTANCE_BANDS", importance_bands(parameters)},
               {"IMPORTANCE_PRECISION", parameters.integer("precision")}} {}

void ImportanceSeries::bind() const {
  energy_.bind_base(GL_UNIFORM_BUFFER, energy_block);
  coefficients_.bind_image(coefficients_image);
}

}  // namespace pellucid
