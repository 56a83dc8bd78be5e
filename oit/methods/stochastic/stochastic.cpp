// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/stochastic/stochastic.h"

#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class Stochastic final : public OitMethod {
 public:
  Stochastic(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        samples_(parameters.integer("samples")),
        average_(stage.target("sums of colour and opacity", GL_RGBA32F)),
        transmittance_(stage.target("transmittance", GL_R32F)),
        nearest_(stage.target("nearest of a sample", GL_RGBA32F)),
        depth_(stage.target("depth of a sample", GL_DEPTH_COMPONENT32F)),
        sum_(stage.target("sum of the samples", GL_RGBA32F)),
        average_target_(stage.gl(), {{average_}, {transmittance_}}),
        nearest_target_(stage.gl(), {{nearest_}, {depth_}}),
        sum_target_(stage.gl(), {{sum_}}),
        accumulate_(stage.geometry_program(oit_glsl::stochastic_accumulate_frag_glsl())),
        sample_(stage.geometry_program(oit_glsl::stochastic_sample_frag_glsl())),
        add_(stage.screen_program(oit_glsl::stochastic_add_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::stochastic_composite_frag_glsl())) {}

  void draw(Frame& frame) override {
    frame.step("accumulate", [&] {
      average_target_.clear(0, 0);
      average_target_.clear(1, 1);
      sum_target_.clear_all(0);
      stage_.begin_pass(average_target_, {Blend::add, Blend::transmit});
      stage_.draw_geometry(accumulate_);
    });
    frame.step("sample", [&] {
      for (int sample = 0; sample < samples_; ++sample)
        draw_sample(std::uint32_t(sample + samples_ * int(frame.sample())));
    });
    frame.step("composite", [&] {
      sum_.bind(0);
      average_.bind(1);
      transmittance_.bind(2);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
    });
  }

 private:
  void draw_sample(std::uint32_t sample) const {
    nearest_target_.clear_all(0);
    nearest_target_.clear_depth(1);
    sample_.set("sample_index", sample);
    stage_.begin_pass(nearest_target_, {Blend::replace});
    stage_.gl().Enable(GL_DEPTH_TEST);
    stage_.gl().DepthFunc(GL_LEQUAL);
    stage_.draw_geometry(sample_);
    stage_.gl().Disable(GL_DEPTH_TEST);
    nearest_.bind(0);
    stage_.begin_pass(sum_target_, {Blend::add});
    stage_.draw_screen(add_);
  }

  const Stage& stage_;
  int samples_;
  Texture average_, transmittance_, nearest_, depth_, sum_;
  Framebuffer average_target_, nearest_target_, sum_target_;
  GeometryProgram accumulate_, sample_;
  Program add_, composite_;
};

constexpr ParameterSpec parameters[] = {{.name = "samples",
                                         .kind = ParameterSpec::Kind::integer,
                                         .default_value = "16",
                                         .min = 1,
                                         .max = 4096,
                                         .unit = "samples",
                                         .help = "passes over the scene, one sample each"}};

}  // namespace

const scene::MethodRow& stochastic_method() {
  static constexpr scene::MethodRow row{
      .name = "stochastic",
      .title = "Stochastic",
      .citation = "Enderton, Sintorn, Shirley and Luebke 2010, Stochastic transparency, I3D",
      .equations = "alpha correction (unnumbered)",
      .parameters = parameters,
      // The random numbers do not know the order; the transmittance is a product of n floats.
      .promises = {.order_spread = 1e-4, .convex_hull = true, .fixed_memory = true, .random = true},
      .bytes_per_pixel = "56",
      .sweep = "samples=4|16|64",
      .make = make_oit<Stochastic>};
  return row;
}

}  // namespace pellucid::oit
