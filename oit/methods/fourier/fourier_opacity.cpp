// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/fourier/fourier_opacity.h"

#include "oit/methods/lists/linked_list.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

/// Steps 2 and 3 of the paper's section 4.2.
struct ObjectSpace {
  ObjectSpace(Stage& stage, const ImportanceSeries& importance, const ElementOptions& options)
      : opacity(stage, options),
        no_targets(stage.gl(), stage.width(), stage.height()),
        optimize(stage.geometry_program(oit_glsl::fourier_opacity_optimize_frag_glsl(),
                                        importance.defines())) {}

  ElementOpacity opacity;
  Framebuffer no_targets;
  GeometryProgram optimize;
};

class FourierOpacity final : public OitMethod {
 public:
  FourierOpacity(Stage& stage, const FourierOpacityOptions& options) : stage_(stage) {
    FragmentOpacity opacity;
    if (has_importance(stage.scene())) opacity = optimize(options);
    compositing_ = options.transmittance == OpacityCompositing::lists
                       ? make_linked_list(stage, opacity)
                       : make_fourier(stage, options.fourier, opacity);
  }

  void draw(Frame& frame) override {
    if (importance_) frame.step("project importance", [&] { importance_->project(); });
    if (objects_) {
      frame.step("optimize opacity", [&] { optimize_elements(); });
      frame.step("smooth opacity", [&] { objects_->opacity.smooth_and_interpolate(); });
    }
    compositing_->draw(frame);
  }

  std::optional<scene::RaySeries> ray_series(scene::RaySum sum, int x, int y,
                                             std::span<const double> d) const override {
    if (sum == scene::RaySum::optical_depth) return compositing_->ray_series(sum, x, y, d);
    if (!importance_) return std::nullopt;
    return importance_->at(x, y, d);
  }

  std::optional<scene::OptimizedOpacities> optimized_opacities() const override {
    if (!objects_) return std::nullopt;
    return objects_->opacity.found();
  }

  std::vector<std::string> explain() const override {
    if (objects_) return {objects_->opacity.describe()};
    return {importance_ ? every_fragment_is_optimized : nothing_is_important};
  }

 private:
  /// Of the fragments that are composited.
  FragmentOpacity optimize(const FourierOpacityOptions& options) {
    stage_.upload_importance();
    ImportanceOptions importance = options.importance;
    if (importance.bands == 0) importance.bands = options.fourier.bands;
    importance_.emplace(stage_, importance, options.fourier.series,
                        scene::energy_weights(options.energy, stage_.scene().energy));
    if (options.per == OpacityUnit::fragment) return importance_->fragment_opacity();
    objects_.emplace(stage_, *importance_, options.elements);
    return ElementOpacity::fragment_opacity();
  }

  void optimize_elements() const {
    objects_->opacity.begin();
    const Resources bound = importance_->resources() + objects_->opacity.image();
    stage_.draw_geometry({objects_->no_targets, {Blend::replace}, bound}, objects_->optimize);
  }

  Stage& stage_;
  std::optional<ImportanceSeries> importance_;
  std::optional<ObjectSpace> objects_;
  std::unique_ptr<OitMethod> compositing_;
};

}  // namespace

const OptionTable<FourierOpacityOptions>& fourier_opacity_options() {
  using Options = FourierOpacityOptions;
  static const OptionTable<Options> table{
      part(&Options::energy, scene::energy_options()),
      part(&Options::fourier, fourier_options()),
      part(&Options::importance, importance_options()),
      opacity_unit_option(&Options::per),
      choice("transmittance", &Options::transmittance,
             {{"fourier", OpacityCompositing::fourier}, {"lists", OpacityCompositing::lists}},
             "what the colours are composited by; lists are exact and show the opacities' errors "
             "alone"),
      part(&Options::elements, element_options())};
  return table;
}

const scene::MethodRow& fourier_opacity_method() {
  static const scene::MethodRow row{
      .name = "fourier-opacity",
      .title = "Fourier opacity optimization",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "1, 2, 10, 11, 14 to 19",
      .checked_against = "the paper",
      .parameters = fourier_opacity_options().specs(),
      .promises = {.order_spread = 1e-3,
                   .convex_hull = true,
                   .optimizes_opacity = true,
                   .optimizes_vertices = true,
                   .one_layer_unless = "normalize=off"},
      .bytes_per_pixel = "precision ceil((2 bands + 1) / 4) + 16",
      .make = make_oit<FourierOpacity, fourier_opacity_options>};
  return row;
}

}  // namespace pellucid::oit
