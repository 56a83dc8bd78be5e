// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/weighted/weighted_sum.h"

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class WeightedSum final : public OitMethod {
 public:
  WeightedSum(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        sums_(stage.target("sums of colour and opacity", GL_RGBA32F)),
        target_(stage.gl(), {{sums_}}),
        accumulate_(stage.geometry_program(oit_glsl::weighted_sum_accumulate_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::weighted_sum_composite_frag_glsl(),
                                        {{"CLAMP", parameters.flag("clamp")}})) {}

  void draw(Frame& frame) override {
    frame.step("accumulate", [&] {
      target_.clear_all(0);
      stage_.draw_geometry({target_, {Blend::add}}, accumulate_);
    });
    frame.step("composite", [&] {
      const Resource sums = sums_.as_texture(bindings::weighted_sums_texture);
      stage_.draw_screen({frame.picture(), {Blend::replace}, sums}, composite_);
    });
  }

 private:
  const Stage& stage_;
  Texture sums_;
  Framebuffer target_;
  GeometryProgram accumulate_;
  Program composite_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "clamp",
     .kind = ParameterSpec::Kind::flag,
     .default_value = "on",
     .choices = "on|off",
     .help = "hold the picture in [0, 1], as an 8-bit frame buffer does"}};

}  // namespace

const scene::MethodRow& weighted_sum_method() {
  static constexpr scene::MethodRow row{
      .name = "weighted-sum",
      .title = "Weighted sum",
      .citation = "Meshkin 2007, Sort-independent alpha blending, GDC",
      .equations = "weighted sum (unnumbered), as later papers cite it",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4, .fixed_memory = true},
      .bytes_per_pixel = "16",
      .make = make_oit<WeightedSum>};
  return row;
}

}  // namespace pellucid::oit
