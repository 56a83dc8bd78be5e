// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/fourier/fourier.h"

#include <glm/vec2.hpp>
#include <optional>

#include "oit_glsl.h"

namespace pellucid::oit::fourier_glsl {

using namespace glm;
#include "oit/optical_depth/fourier_series.glsl"

}  // namespace pellucid::oit::fourier_glsl

namespace pellucid::oit {
namespace {

class Fourier final : public OitMethod {
 public:
  Fourier(Stage& stage, const FourierOptions& options, const FragmentOpacity& opacity = {})
      : bands_(options.bands),
        margin_(float(options.series.margin)),
        target_(fourier_target(bands_, options.series)),
        passes_(stage, {{"Fourier coefficients", target_.format, target_.layers}},
                weight_program(stage, options, opacity),
                stage.screen_program(oit_glsl::fourier_composite_frag_glsl(),
                                     {{"NORMALIZE", options.normalize}})),
        projection_(stage, passes_.coefficients(0), bands_, options.series, {}, opacity) {}

  void draw(Frame& frame) override {
    frame.step("project", [&] { projection_.project(); });
    passes_.weight_and_composite(frame);
  }

  // As the weight pass does it, in the same formulas.
  std::optional<scene::OpticalDepth> optical_depth(int x, int y,
                                                   std::span<const double> d) const override {
    std::vector<glm::vec2> coefficients(std::size_t(2 * target_.layers));
    passes_.coefficients(0).read_pixel(x, y, target_.layers, GL_RGBA, GL_FLOAT,
                                       coefficients.size() * sizeof coefficients[0],
                                       coefficients.data());
    scene::OpticalDepth result;
    for (int k = 0; k <= bands_; ++k)
      result.harmonics.emplace_back(coefficients[std::size_t(k)].x, coefficients[std::size_t(k)].y);
    for (const double depth : d)
      result.values.push_back(tau_at((float(depth) + margin_) / (1 + 2 * margin_), coefficients));
    return result;
  }

 private:
  float tau_at(float d, const std::vector<glm::vec2>& coefficients) const {
    const glm::vec2 one_band = fourier_glsl::first_wave(d);
    glm::vec2 wave(1, 0);
    float tau = 0;
    for (int k = 0; k <= bands_; ++k) {
      tau += fourier_glsl::fourier_integral(k, coefficients[std::size_t(k)], d, wave);
      wave = fourier_glsl::add_angles(wave, one_band);
    }
    return tau;
  }

  static GeometryProgram weight_program(const Stage& stage, const FourierOptions& options,
                                        const FragmentOpacity& opacity) {
    return fourier_program(stage, oit_glsl::fourier_weight_frag_glsl(),
                           {{"BANDS", options.bands},
                            {"PRECISION", options.series.precision},
                            {"MIDDLE", options.series.at == SeriesValue::middle}},
                           options.series, opacity);
  }

  int bands_;
  float margin_;
  FourierTarget target_;
  OpticalDepthPasses passes_;
  FourierProjection projection_;
};

}  // namespace

std::unique_ptr<OitMethod> make_fourier(Stage& stage, const FourierOptions& options,
                                        const FragmentOpacity& opacity) {
  return std::make_unique<Fourier>(stage, options, opacity);
}

const OptionTable<FourierOptions>& fourier_options() {
  static const OptionTable<FourierOptions> table{
      number("bands", &FourierOptions::bands,
             {.min = 1,
              .max = 64,
              .unit = "bands",
              .help = "frequencies of the series (m in the paper); beyond 15 each 16 more take "
                      "another pass"}),
      normalize_option(&FourierOptions::normalize),
      part(&FourierOptions::series, series_options())};
  return table;
}

const scene::MethodRow& fourier_method() {
  static const scene::MethodRow row{
      .name = "fourier",
      .title = "Fourier",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "14 to 19",
      .checked_against = "the paper",
      .parameters = fourier_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .one_layer_unless = "normalize=off"},
      .bytes_per_pixel = "precision / 2 ceil((2 bands + 1) / 4) + 16",
      .sweep = "bands=1|2|3|5|8|10|15",
      .make = make_oit<Fourier, fourier_options>};
  return row;
}

}  // namespace pellucid::oit
