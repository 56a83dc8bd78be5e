// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/fourier/fourier_opacity.h"

#include "oit/methods/fourier/fourier.h"
#include "oit/methods/lists/linked_list.h"
#include "oit/opacity/element_opacity.h"
#include "oit/opacity/importance_series.h"
#include "oit_glsl.h"
#include "scene/opacity_energy.h"

namespace pellucid::oit {
namespace {

/// Steps 2 and 3 of the paper's section 4.2.
struct ObjectSpace {
  ObjectSpace(Stage& stage, const ImportanceSeries& importance, const Parameters& parameters)
      : opacity(stage, parameters),
        no_targets(stage.gl(), stage.width(), stage.height()),
        optimize(stage.geometry_program(oit_glsl::fourier_opacity_optimize_frag_glsl(),
                                        importance.defines())) {}

  ElementOpacity opacity;
  Framebuffer no_targets;
  GeometryProgram optimize;
};

class FourierOpacity final : public OitMethod {
 public:
  FourierOpacity(Stage& stage, const Parameters& parameters) : stage_(stage) {
    FragmentOpacity opacity;
    if (has_importance(stage.scene())) opacity = optimize(parameters);
    compositing_ = parameters.text("transmittance") == "lists"
                       ? make_linked_list(stage, opacity)
                       : make_fourier(stage, parameters, opacity);
  }

  void draw(Frame& frame) override {
    if (importance_) {
      frame.step("project importance", [&] { importance_->project(); });
      importance_->bind();
    }
    if (objects_) {
      frame.step("optimize opacity", [&] { optimize_elements(); });
      frame.step("smooth opacity", [&] { objects_->opacity.smooth_and_interpolate(); });
    }
    compositing_->draw(frame);
  }

  std::vector<std::string> explain() const override {
    if (objects_) return {objects_->opacity.describe()};
    return {importance_ ? "opacities: of least energy, at every fragment" : nothing_is_important};
  }

 private:
  /// Of the fragments that are composited.
  FragmentOpacity optimize(const Parameters& parameters) {
    stage_.upload_importance();
    importance_.emplace(stage_, parameters);
    if (parameters.text("per") == "fragment") return importance_->fragment_opacity();
    objects_.emplace(stage_, *importance_, parameters);
    return ElementOpacity::fragment_opacity();
  }

  void optimize_elements() const {
    objects_->opacity.begin();
    stage_.begin_pass(objects_->no_targets, {Blend::replace});
    stage_.draw_geometry(objects_->optimize);
  }

  Stage& stage_;
  std::optional<ImportanceSeries> importance_;
  std::optional<ObjectSpace> objects_;
  std::unique_ptr<OitMethod> compositing_;
};

constexpr ParameterSpec per_parameter = {
    .name = "per",
    .kind = ParameterSpec::Kind::choice,
    .default_value = "element",
    .choices = "element|fragment",
    .help =
        "what has one opacity: a segment of a line, a patch of a surface, a point; or each "
        "fragment, as it comes"};

constexpr ParameterSpec transmittance_parameter = {
    .name = "transmittance",
    .kind = ParameterSpec::Kind::choice,
    .default_value = "fourier",
    .choices = "fourier|lists",
    .help =
        "what the colours are composited by; lists are exact and show the opacities' errors alone"};

constexpr ParameterSpec importance_bands_parameter = {
    .name = "importance-bands",
    .kind = ParameterSpec::Kind::integer,
    .default_value = "0",
    .min = 0,
    .max = 64,
    .unit = "bands",
    .help = "of the series of the importance; 0: as many as `bands`, the optical depth's"};

constexpr ParameterSpec importance_resolution_parameter = {
    .name = "importance-resolution",
    .kind = ParameterSpec::Kind::choice,
    .default_value = "full",
    .choices = "full|half",
    .help = "of the importance's series: one a pixel, or one for 2 x 2"};

constexpr auto parameters =
    concatenate(scene::energy_parameters, fourier_parameters,
                std::array{importance_bands_parameter, importance_resolution_parameter,
                           per_parameter, transmittance_parameter},
                element_parameters);

}  // namespace

const scene::MethodRow& fourier_opacity_method() {
  static constexpr scene::MethodRow row{
      .name = "fourier-opacity",
      .title = "Fourier opacity optimization",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "1, 2, 10, 11, 14 to 19",
      .parameters = parameters,
      .promises = {.order_spread = 1e-3,
                   .convex_hull = true,
                   .optimizes_opacity = true,
                   .one_layer_unless = "normalize=off"},
      .bytes_per_pixel = "precision ceil((2 bands + 1) / 4) + 16",
      .make = make_oit<FourierOpacity>};
  return row;
}

}  // namespace pellucid::oit
