// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/k_buffer/k_buffer.h"

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class KBuffer final : public OitMethod {
 public:
  KBuffer(Stage& stage, const KBufferOptions& options)
      : stage_(stage),
        layers_(std::uint32_t(options.layers)),
        depths_(stage.target("nearest depths", GL_R32UI, options.layers)),
        colors_(stage.target("nearest colours", GL_RGBA32F, options.layers)),
        tail_(stage.target("sums of the tail", GL_RGBA32F)),
        transmittance_(stage.target("transmittance of the tail", GL_R32F)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        tail_target_(stage.gl(), {{tail_}, {transmittance_}}) {
    const Defines defines = {{"LAYERS", options.layers}};
    nearest_ = stage.geometry_program(oit_glsl::k_buffer_nearest_frag_glsl(), defines);
    color_ = stage.geometry_program(oit_glsl::k_buffer_color_frag_glsl(), defines);
    composite_ = stage.screen_program(oit_glsl::k_buffer_composite_frag_glsl(), defines);
  }

  void draw(Frame& frame) override {
    frame.step("find the nearest", [&] {
      depths_.clear(~0u);
      stage_.draw_geometry({no_targets_, {Blend::replace}, layers()}, nearest_);
      finish_stores();
    });
    frame.step("colour", [&] {
      tail_target_.clear(0, 0);
      tail_target_.clear(1, 1);
      stage_.draw_geometry({tail_target_, {Blend::add, Blend::transmit}, layers()}, color_);
      finish_stores();
    });
    frame.step("composite", [&] {
      const Resources tail{tail_.as_texture(bindings::tail_texture),
                           transmittance_.as_texture(bindings::tail_transmittance_texture)};
      stage_.draw_screen({frame.picture(), {Blend::replace}, layers() + tail}, composite_);
    });
  }

  // The tail is summed up: nothing is lost.
  void account(const CountImage& crossings, scene::RenderStats& stats) const override {
    for (const std::uint32_t n : crossings.pixels) stats.stored += std::min(n, layers_);
  }

 private:
  Resources layers() const {
    return {depths_.as_image(bindings::k_depths_image), colors_.as_image(bindings::k_colors_image)};
  }
  void finish_stores() const { stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT); }

  const Stage& stage_;
  std::uint32_t layers_;
  Texture depths_, colors_, tail_, transmittance_;
  Framebuffer no_targets_, tail_target_;
  GeometryProgram nearest_, color_;
  Program composite_;
};

}  // namespace

const OptionTable<KBufferOptions>& k_buffer_options() {
  static const OptionTable<KBufferOptions> table{
      number("layers", &KBufferOptions::layers,
             {.min = 1,
              .max = 64,
              .unit = "layers",
              .help = "nearest fragments that are kept apart (k)"})};
  return table;
}

const scene::MethodRow& k_buffer_method() {
  static const scene::MethodRow row{
      .name = "k-buffer",
      .title = "k-buffer with a tail",
      .citation = "Maule, Comba, Torchelsen and Bastos 2013, Hybrid transparency, I3D",
      .equations = "core and tail (unnumbered)",
      .checked_against = "not recorded",
      .parameters = k_buffer_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.exact_layers = "layers",
                   .order_spread = 1e-4,
                   .convex_hull = true,
                   .fixed_memory = true},
      .bytes_per_pixel = "20 layers + 20",
      .sweep = "layers=2|4|8|16",
      .make = make_oit<KBuffer, k_buffer_options>};
  return row;
}

}  // namespace pellucid::oit
