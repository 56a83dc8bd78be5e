#include "oit/methods/fourier.h"

#include "oit/fourier_projection.h"
#include "oit/optical_depth_passes.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

class Fourier final : public OitMethod {
 public:
  Fourier(Stage& stage, const Parameters& parameters)
      : passes_(stage, coefficients(parameters), weight_program(stage, parameters),
                stage.screen_program(oit_glsl::fourier_composite_frag_glsl(),
                                     {{"NORMALIZE", parameters.flag("normalize")}})),
        projection_(stage, passes_.coefficients(0), parameters.integer("bands"), parameters) {}

  void draw(Frame& frame) override {
    frame.step("project", [&] { projection_.project(); });
    passes_.weight_and_composite(frame);
  }

 private:
  static std::vector<OpticalDepthPasses::Target> coefficients(const Parameters& parameters) {
    const FourierTarget target = fourier_target(parameters.integer("bands"), parameters);
    return {{"Fourier coefficients", target.format, target.layers}};
  }

  static GeometryProgram weight_program(const Stage& stage, const Parameters& parameters) {
    return fourier_program(stage, oit_glsl::fourier_weight_frag_glsl(),
                           {{"BANDS", parameters.integer("bands")},
                            {"PRECISION", parameters.integer("precision")},
                            {"MIDDLE", parameters.text("at") == "middle"}},
                           parameters);
  }

  OpticalDepthPasses passes_;
  FourierProjection projection_;
};

}  // namespace

std::unique_ptr<OitMethod> make_fourier(Stage& stage, const Parameters& parameters) {
  return std::make_unique<Fourier>(stage, parameters);
}

const MethodRow& fourier_method() {
  static constexpr MethodRow row{
      .name = "fourier",
      .title = "Fourier",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "14 to 19",
      .parameters = fourier_parameters,
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "precision / 2 ceil((2 bands + 1) / 4) + 16",
      .sweep = "bands=1|2|3|5|8|10|15",
      .make = make_oit<Fourier>};
  return row;
}

}  // namespace pellucid
