// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/weighted/weighted_sum.h"

#include "oit/gl/bindings.h"
#include "oit/stage/summing_method.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class WeightedSum final : public SummingMethod {
 public:
  WeightedSum(Stage& stage, const WeightedSumOptions& options)
      : stage_(stage),
        sums_(stage.target("sums of colour and opacity", GL_RGBA32F)),
        target_(stage.gl(), {{sums_}}),
        accumulate_(stage.geometry_program(oit_glsl::weighted_sum_accumulate_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::weighted_sum_composite_frag_glsl(),
                                        {{"CLAMP", options.clamp}})) {}

  int rounds() const override { return 1; }
  std::vector<SumTarget> targets(int) const override {
    return {{"sums of colour and opacity", &sums_}};
  }
  void sum(int, Frame& frame) override {
    frame.step("accumulate", [&] {
      target_.clear_all(0);
      stage_.draw_geometry({target_, {Blend::add}}, accumulate_);
    });
  }
  void composite(Frame& frame) override {
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

}  // namespace

const OptionTable<WeightedSumOptions>& weighted_sum_options() {
  static const OptionTable<WeightedSumOptions> table{
      flag("clamp", &WeightedSumOptions::clamp,
           "hold the picture in [0, 1], as an 8-bit frame buffer does")};
  return table;
}

const scene::MethodRow& weighted_sum_method() {
  static const scene::MethodRow row{
      .name = "weighted-sum",
      .title = "Weighted sum",
      .citation = "Meshkin 2007, Sort-independent alpha blending, GDC",
      .equations = "weighted sum (unnumbered), as later papers cite it",
      .checked_against =
          "later papers' citation of it (Bavoil and Myers 2008, McGuire and Bavoil 2013); the "
          "talk was not at hand",
      .parameters = weighted_sum_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4, .fixed_memory = true, .adds_up = true},
      .bytes_per_pixel = "16",
      .make = make_oit<WeightedSum, weighted_sum_options>};
  return row;
}

}  // namespace pellucid::oit
