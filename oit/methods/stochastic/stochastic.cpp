// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/stochastic/stochastic.h"

#include <limits>

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class Stochastic final : public OitMethod {
 public:
  Stochastic(Stage& stage, const StochasticOptions& options)
      : stage_(stage),
        samples_(options.samples),
        seed_(std::uint32_t(options.seed)),
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
      stage_.draw_geometry({average_target_, {Blend::add, Blend::transmit}}, accumulate_);
    });
    frame.step("sample", [&] {
      sample_.set("seed", seed_ + frame.draw());
      for (int sample = 0; sample < samples_; ++sample)
        draw_sample(std::uint32_t(sample + samples_ * int(frame.sample())));
    });
    frame.step("composite", [&] {
      stage_.draw_screen({frame.picture(),
                          {Blend::replace},
                          {sum_.as_texture(bindings::sample_sum_texture),
                           average_.as_texture(bindings::sample_average_texture),
                           transmittance_.as_texture(bindings::sample_transmittance_texture)}},
                         composite_);
    });
  }

 private:
  void draw_sample(std::uint32_t sample) const {
    nearest_target_.clear_all(0);
    nearest_target_.clear_depth(1);
    sample_.set("sample_index", sample);
    stage_.draw_geometry({nearest_target_, {Blend::replace}, {}, DepthTest::less_or_equal},
                         sample_);
    const Resource nearest = nearest_.as_texture(bindings::sample_texture);
    stage_.draw_screen({sum_target_, {Blend::add}, nearest}, add_);
  }

  const Stage& stage_;
  int samples_;
  std::uint32_t seed_;
  Texture average_, transmittance_, nearest_, depth_, sum_;
  Framebuffer average_target_, nearest_target_, sum_target_;
  GeometryProgram accumulate_, sample_;
  Program add_, composite_;
};

}  // namespace

const OptionTable<StochasticOptions>& stochastic_options() {
  static const OptionTable<StochasticOptions> table{
      number("samples", &StochasticOptions::samples,
             {.min = 1,
              .max = 4096,
              .unit = "samples",
              .help = "passes over the scene, one sample each"}),
      number("seed", &StochasticOptions::seed,
             {.min = 0,
              .max = std::numeric_limits<int>::max(),
              .help = "of the random numbers; a study judges by this one and the next four"})};
  return table;
}

const scene::MethodRow& stochastic_method() {
  static const scene::MethodRow row{
      .name = "stochastic",
      .title = "Stochastic",
      .citation = "Enderton, Sintorn, Shirley and Luebke 2010, Stochastic transparency, I3D",
      .equations = "alpha correction (unnumbered)",
      .checked_against = "not recorded",
      .parameters = stochastic_options().specs(),
      // The random numbers do not know the order; the transmittance is a product of n floats.
      .promises = {.order_spread = 1e-4, .convex_hull = true, .fixed_memory = true, .random = true},
      .bytes_per_pixel = "56",
      .sweep = "samples=4|16|64",
      .make = make_oit<Stochastic, stochastic_options>};
  return row;
}

}  // namespace pellucid::oit
