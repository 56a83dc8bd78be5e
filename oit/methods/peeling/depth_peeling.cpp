// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/peeling/depth_peeling.h"

#include <limits>

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class DepthPeeling final : public OitMethod {
 public:
  DepthPeeling(Stage& stage, const DepthPeelingOptions& options)
      : stage_(stage),
        most_peels_(options.peels.value_or(std::numeric_limits<int>::max())),
        peeled_(stage.target("last peeled key", GL_RG32UI)),
        depth_(stage.target("nearest depth", GL_DEPTH_COMPONENT32F)),
        order_(stage.target("first in order", GL_DEPTH_COMPONENT32F)),
        layer_(stage.target("peeled layer", GL_RGBA32F)),
        layer_key_(stage.target("key of the peeled layer", GL_RG32UI)),
        sum_(stage.target("composited layers", GL_RGBA32F)),
        depth_target_(stage.gl(), {{depth_}}),
        layer_target_(stage.gl(), {{layer_}, {layer_key_}, {order_}}),
        sum_target_(stage.gl(), {{sum_}, {peeled_}}),
        query_(stage.gl()),
        nearest_(stage.geometry_program(oit_glsl::depth_peeling_nearest_frag_glsl())),
        peel_(stage.geometry_program(oit_glsl::depth_peeling_peel_frag_glsl())),
        add_(stage.screen_program(oit_glsl::depth_peeling_add_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::depth_peeling_composite_frag_glsl())) {}

  void draw(Frame& frame) override {
    frame.step("clear", [&] {
      sum_target_.clear(0, 0);
      peeled_.clear(0);
    });
    std::uint64_t left = 1;
    for (int peel = 0; peel < most_peels_ && left > 0; ++peel) {
      frame.step("find the nearest", [&] { left = find_nearest(); });
      if (left > 0) frame.step("peel", [&] { peel_layer(); });
    }
    frame.step("composite", [&] {
      const Resource sum = sum_.as_texture(bindings::peeled_sum_texture);
      stage_.draw_screen({frame.picture(), {Blend::replace}, sum}, composite_);
    });
    if (left > 0) frame.stats().dropped = count_left();
  }

  void account(const CountImage& crossings, scene::RenderStats& stats) const override {
    for (const std::uint32_t n : crossings.pixels) {
      stats.stored += std::min<std::uint64_t>(n, std::uint64_t(most_peels_));
      stats.truncated += n > std::uint64_t(most_peels_);
    }
  }

 private:
  Resource peeled_keys() const { return peeled_.as_texture(bindings::peeled_keys_texture); }

  // Returns 0 when nothing is left.
  std::uint64_t find_nearest() const {
    depth_target_.clear_depth(1);
    return draw_left(DepthTest::less_or_equal);
  }

  void peel_layer() const {
    layer_target_.clear(0, -1);
    layer_target_.clear_depth(1);
    const Resources found{peeled_keys(), depth_.as_texture(bindings::nearest_depth_texture)};
    stage_.draw_geometry({layer_target_, {Blend::replace}, found, DepthTest::less_or_equal}, peel_);
    const Resources layer{layer_.as_texture(bindings::peeled_layer_texture),
                          layer_key_.as_texture(bindings::peeled_layer_key_texture)};
    stage_.draw_screen({sum_target_, {Blend::under, Blend::replace}, layer}, add_);
  }

  // Without a depth test every fragment that is left passes.
  std::uint64_t count_left() const { return draw_left(DepthTest::off); }

  std::uint64_t draw_left(DepthTest test) const {
    query_.begin();
    stage_.draw_geometry({depth_target_, {Blend::replace}, peeled_keys(), test}, nearest_);
    return query_.end();
  }

  const Stage& stage_;
  int most_peels_;
  Texture peeled_, depth_, order_, layer_, layer_key_, sum_;
  Framebuffer depth_target_, layer_target_, sum_target_;
  SampleQuery query_;
  GeometryProgram nearest_, peel_;
  Program add_, composite_;
};

}  // namespace

const OptionTable<DepthPeelingOptions>& depth_peeling_options() {
  static const OptionTable<DepthPeelingOptions> table{number(
      "peels", &DepthPeelingOptions::peels,
      {.min = 1, .max = 1e6, .unit = "layers", .help = "budget of layers; not set: all of them"})};
  return table;
}

const scene::MethodRow& depth_peeling_method() {
  static const scene::MethodRow row{
      .name = "depth-peeling",
      .title = "Depth peeling",
      .citation = "Everitt 2001, Interactive order-independent transparency, NVIDIA",
      .equations = "none; the two depth tests of its section on depth peeling",
      .checked_against = "not recorded",
      .parameters = depth_peeling_options().specs(),
      .promises = {.exact = true,
                   .exact_unless = "peels",
                   .order_independent = true,
                   .convex_hull = true,
                   .fixed_memory = true},
      .bytes_per_pixel = "56",
      .make = make_oit<DepthPeeling, depth_peeling_options>};
  return row;
}

}  // namespace pellucid::oit
