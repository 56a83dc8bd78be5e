// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/k_buffer/k_buffer.h"

#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class KBuffer final : public OitMethod {
 public:
  KBuffer(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        layers_(std::uint32_t(parameters.integer("layers"))),
        depths_(stage.target("nearest depths", GL_R32UI, parameters.integer("layers"))),
        colors_(stage.target("nearest colours", GL_RGBA32F, parameters.integer("layers"))),
        tail_(stage.target("sums of the tail", GL_RGBA32F)),
        transmittance_(stage.target("transmittance of the tail", GL_R32F)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        tail_target_(stage.gl(), {{tail_}, {transmittance_}}) {
    const Defines defines = {{"LAYERS", parameters.integer("layers")}};
    nearest_ = stage.geometry_program(oit_glsl::k_buffer_nearest_frag_glsl(), defines);
    color_ = stage.geometry_program(oit_glsl::k_buffer_color_frag_glsl(), defines);
    composite_ = stage.screen_program(oit_glsl::k_buffer_composite_frag_glsl(), defines);
  }

  void draw(Frame& frame) override {
    frame.step("find the nearest", [&] {
      depths_.clear(~0u);
      depths_.bind_image(0);
      colors_.bind_image(1);
      stage_.begin_pass(no_targets_, {Blend::replace});
      stage_.draw_geometry(nearest_);
      finish_stores();
    });
    frame.step("colour", [&] {
      tail_target_.clear(0, 0);
      tail_target_.clear(1, 1);
      stage_.begin_pass(tail_target_, {Blend::add, Blend::transmit});
      stage_.draw_geometry(color_);
      finish_stores();
    });
    frame.step("composite", [&] {
      tail_.bind(0);
      transmittance_.bind(1);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
    });
  }

  // The tail is summed up: nothing is lost.
  void account(const CountImage& crossings, scene::RenderStats& stats) const override {
    for (const std::uint32_t n : crossings.pixels) stats.stored += std::min(n, layers_);
  }

 private:
  void finish_stores() const { stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT); }

  const Stage& stage_;
  std::uint32_t layers_;
  Texture depths_, colors_, tail_, transmittance_;
  Framebuffer no_targets_, tail_target_;
  GeometryProgram nearest_, color_;
  Program composite_;
};

constexpr ParameterSpec parameters[] = {{.name = "layers",
                                         .kind = ParameterSpec::Kind::integer,
                                         .default_value = "8",
                                         .min = 1,
                                         .max = 64,
                                         .unit = "layers",
                                         .help = "nearest fragments that are kept apart (k)"}};

}  // namespace

const scene::MethodRow& k_buffer_method() {
  static constexpr scene::MethodRow row{
      .name = "k-buffer",
      .title = "k-buffer with a tail",
      .citation = "Maule, Comba, Torchelsen and Bastos 2013, Hybrid transparency, I3D",
      .equations = "core and tail (unnumbered)",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.exact_layers = "layers",
                   .order_spread = 1e-4,
                   .convex_hull = true,
                   .fixed_memory = true},
      .bytes_per_pixel = "20 layers + 20",
      .sweep = "layers=2|4|8|16",
      .make = make_oit<KBuffer>};
  return row;
}

}  // namespace pellucid::oit
