// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/weighted/weighted_average.h"

#include "oit/gl/bindings.h"
#include "oit/stage/summing_method.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class WeightedAverage final : public SummingMethod {
 public:
  explicit WeightedAverage(Stage& stage)
      : stage_(stage),
        sums_(stage.target("sums of colour and opacity", GL_RGBA32F)),
        count_(stage.target("fragment count", GL_R32F)),
        targets_(stage.gl(), {{sums_}, {count_}}),
        accumulate_(stage.geometry_program(oit_glsl::weighted_average_accumulate_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::weighted_average_composite_frag_glsl())) {}

  int rounds() const override { return 1; }
  std::vector<SumTarget> targets(int) const override {
    return {{"sums of colour and opacity", &sums_}, {"fragment count", &count_}};
  }
  void sum(int, Frame& frame) override {
    frame.step("accumulate", [&] {
      targets_.clear_all(0);
      stage_.draw_geometry({targets_, {Blend::add}}, accumulate_);
    });
  }
  void composite(Frame& frame) override {
    frame.step("composite", [&] {
      stage_.draw_screen({frame.picture(),
                          {Blend::replace},
                          {sums_.as_texture(bindings::weighted_sums_texture),
                           count_.as_texture(bindings::fragment_count_texture)}},
                         composite_);
    });
  }

 private:
  const Stage& stage_;
  Texture sums_, count_;
  Framebuffer targets_;
  GeometryProgram accumulate_;
  Program composite_;
};

}  // namespace

const scene::MethodRow& weighted_average_method() {
  static constexpr scene::MethodRow row{
      .name = "weighted-average",
      .title = "Weighted average",
      .citation = "Bavoil and Myers 2008, Order independent transparency with dual depth peeling",
      .equations = "weighted average (unnumbered)",
      .checked_against = "not recorded",
      .parameters = {},
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true},
      .bytes_per_pixel = "20",
      .make = make_oit<WeightedAverage>};
  return row;
}

}  // namespace pellucid::oit
