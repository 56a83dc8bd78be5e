#include "oit/methods/fourier_opacity.h"

#include <algorithm>

#include "oit/importance_series.h"
#include "oit/methods/fourier.h"
#include "scene/opacity_energy.h"

namespace pellucid {
namespace {

bool is_important(const SceneObject& object) {
  return !object.opaque &&
         std::ranges::any_of(object.vertices().importance, [](float g) { return g > 0; });
}

class FourierOpacity final : public OitMethod {
 public:
  FourierOpacity(Stage& stage, const Parameters& parameters) {
    if (std::ranges::any_of(stage.scene().objects, is_important)) {
      stage.upload_importance();
      importance_.emplace(stage, parameters);
      stage.define(importance_->defines());
      stage.define({{"OPTIMIZED_FRAGMENTS", 1}});
    }
    compositing_ = make_fourier(stage, parameters);
  }

  void draw(Frame& frame) override {
    if (importance_) {
      frame.step("project importance", [&] { importance_->project(); });
      importance_->bind();
    }
    compositing_->draw(frame);
  }

  std::vector<std::string> explain() const override {
    return {importance_ ? "opacities: of least energy, at every fragment"
                        : "opacities: the scene's own, nothing in it is important"};
  }

 private:
  std::optional<ImportanceSeries> importance_;
  std::unique_ptr<OitMethod> compositing_;
};

constexpr ParameterSpec importance_bands_parameter = {
    .name = "importance-bands",
    .kind = ParameterSpec::Kind::integer,
    .default_value = "0",
    .min = 0,
    .max = 64,
    .unit = "bands",
    .help = "of the series of the importance; 0: as many as `bands`, the optical depth's"};

constexpr auto parameters =
    concatenate(energy_parameters, fourier_parameters, std::array{importance_bands_parameter});

}  // namespace

const MethodRow& fourier_opacity_method() {
  static constexpr MethodRow row{
      .name = "fourier-opacity",
      .title = "Fourier opacity optimization",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "1, 2, 10, 11, 14 to 19",
      .parameters = parameters,
      .promises = {.order_spread = 1e-3, .convex_hull = true},
      .bytes_per_pixel = "precision ceil((2 bands + 1) / 4) + 16",
      .optimizes_opacity = true,
      .make = make_oit<FourierOpacity>};
  return row;
}

}  // namespace pellucid
