// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/weighted/weighted_blended.h"

#include "oit/gl/bindings.h"
#include "oit/stage/summing_method.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class WeightedBlended final : public SummingMethod {
 public:
  WeightedBlended(Stage& stage, const WeightedBlendedOptions& options)
      : stage_(stage),
        sums_(stage.target("weighted sums of colour and opacity", GL_RGBA32F)),
        transmittance_(stage.target("transmittance", GL_R32F)),
        targets_(stage.gl(), {{sums_}, {transmittance_}}),
        accumulate_(stage.geometry_program(oit_glsl::weighted_blended_accumulate_frag_glsl(),
                                           {{"WEIGHT", options.weight}})),
        composite_(stage.screen_program(oit_glsl::weighted_blended_composite_frag_glsl())) {}

  int rounds() const override { return 1; }
  std::vector<SumTarget> targets(int) const override {
    return {{"weighted sums of colour and opacity", &sums_},
            {"transmittance", &transmittance_, scene::Combine::multiply}};
  }
  void sum(int, Frame& frame) override {
    frame.step("accumulate", [&] {
      targets_.clear(0, 0);
      targets_.clear(1, 1);
      stage_.draw_geometry({targets_, {Blend::add, Blend::transmit}}, accumulate_);
    });
  }
  void composite(Frame& frame) override {
    frame.step("composite", [&] {
      stage_.draw_screen({frame.picture(),
                          {Blend::replace},
                          {sums_.as_texture(bindings::weighted_sums_texture),
                           transmittance_.as_texture(bindings::weighted_transmittance_texture)}},
                         composite_);
    });
  }

 private:
  const Stage& stage_;
  Texture sums_, transmittance_;
  Framebuffer targets_;
  GeometryProgram accumulate_;
  Program composite_;
};

}  // namespace

const OptionTable<WeightedBlendedOptions>& weighted_blended_options() {
  static const OptionTable<WeightedBlendedOptions> table{
      choice("weight", &WeightedBlendedOptions::weight,
             {{"none", 0}, {"7", 7}, {"8", 8}, {"9", 9}, {"10", 10}},
             "number of the weight's equation in the paper; none: no weight")};
  return table;
}

const scene::MethodRow& weighted_blended_method() {
  static const scene::MethodRow row{
      .name = "weighted-blended",
      .title = "Weighted blended",
      .citation =
          "McGuire and Bavoil 2013, Weighted blended order-independent transparency, "
          "JCGT 2(2)",
      .equations = "weights 7, 8, 9, 10",
      .checked_against =
          "three public implementations that cite the paper's equations by number; the "
          "paper was not at hand",
      .parameters = weighted_blended_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true},
      .bytes_per_pixel = "20",
      .sweep = "weight=7|8|9|10",
      .make = make_oit<WeightedBlended, weighted_blended_options>};
  return row;
}

}  // namespace pellucid::oit
