// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/weighted/weighted_blended.h"

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class WeightedBlended final : public OitMethod {
 public:
  WeightedBlended(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        sums_(stage.target("weighted sums of colour and opacity", GL_RGBA32F)),
        transmittance_(stage.target("transmittance", GL_R32F)),
        targets_(stage.gl(), {{sums_}, {transmittance_}}),
        accumulate_(stage.geometry_program(oit_glsl::weighted_blended_accumulate_frag_glsl(),
                                           {{"WEIGHT", weight(parameters)}})),
        composite_(stage.screen_program(oit_glsl::weighted_blended_composite_frag_glsl())) {}

  void draw(Frame& frame) override {
    frame.step("accumulate", [&] {
      targets_.clear(0, 0);
      targets_.clear(1, 1);
      stage_.draw_geometry({targets_, {Blend::add, Blend::transmit}}, accumulate_);
    });
    frame.step("composite", [&] {
      stage_.draw_screen({frame.picture(),
                          {Blend::replace},
                          {sums_.as_texture(bindings::weighted_sums_texture),
                           transmittance_.as_texture(bindings::weighted_transmittance_texture)}},
                         composite_);
    });
  }

 private:
  static int weight(const Parameters& parameters) {
    return parameters.text("weight") == "none" ? 0 : parameters.integer("weight");
  }

  const Stage& stage_;
  Texture sums_, transmittance_;
  Framebuffer targets_;
  GeometryProgram accumulate_;
  Program composite_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "weight",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "10",
     .choices = "none|7|8|9|10",
     .help = "number of the weight's equation in the paper; none: no weight"}};

}  // namespace

const scene::MethodRow& weighted_blended_method() {
  static constexpr scene::MethodRow row{
      .name = "weighted-blended",
      .title = "Weighted blended",
      .citation =
          "McGuire and Bavoil 2013, Weighted blended order-independent transparency, "
          "JCGT 2(2)",
      .equations = "weights 7, 8, 9, 10",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "20",
      .sweep = "weight=7|8|9|10",
      .make = make_oit<WeightedBlended>};
  return row;
}

}  // namespace pellucid::oit
