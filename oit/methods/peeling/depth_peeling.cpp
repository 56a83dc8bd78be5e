// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/peeling/depth_peeling.h"

#include <limits>

#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class DepthPeeling final : public OitMethod {
 public:
  DepthPeeling(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        most_peels_(parameters.is_set("peels") ? parameters.integer("peels")
                                               : std::numeric_limits<int>::max()),
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
      sum_.bind(0);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
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
  void depth_test(bool on) const {
    on ? stage_.gl().Enable(GL_DEPTH_TEST) : stage_.gl().Disable(GL_DEPTH_TEST);
    stage_.gl().DepthFunc(GL_LEQUAL);
  }

  // Returns 0 when nothing is left.
  std::uint64_t find_nearest() const {
    depth_target_.clear_depth(1);
    depth_test(true);
    const std::uint64_t passed = draw_left();
    depth_test(false);
    return passed;
  }

  void peel_layer() const {
    layer_target_.clear(0, -1);
    layer_target_.clear_depth(1);
    depth_test(true);
    depth_.bind(1);
    stage_.begin_pass(layer_target_, {Blend::replace});
    stage_.draw_geometry(peel_);
    depth_test(false);
    layer_.bind(0);
    layer_key_.bind(1);
    stage_.begin_pass(sum_target_, {Blend::under, Blend::replace});
    stage_.draw_screen(add_);
  }

  // Without a depth test every fragment that is left passes.
  std::uint64_t count_left() const { return draw_left(); }

  std::uint64_t draw_left() const {
    peeled_.bind(0);
    stage_.begin_pass(depth_target_, {Blend::replace});
    query_.begin();
    stage_.draw_geometry(nearest_);
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

constexpr ParameterSpec parameters[] = {{.name = "peels",
                                         .kind = ParameterSpec::Kind::integer,
                                         .default_value = "",
                                         .min = 1,
                                         .max = 1e6,
                                         .unit = "layers",
                                         .help = "budget of layers; not set: all of them"}};

}  // namespace

const scene::MethodRow& depth_peeling_method() {
  static constexpr scene::MethodRow row{
      .name = "depth-peeling",
      .title = "Depth peeling",
      .citation = "Everitt 2001, Interactive order-independent transparency, NVIDIA",
      .equations = "none; the two depth tests of its section on depth peeling",
      .parameters = parameters,
      .promises = {.exact = true,
                   .exact_unless = "peels",
                   .order_independent = true,
                   .convex_hull = true,
                   .fixed_memory = true},
      .bytes_per_pixel = "56",
      .make = make_oit<DepthPeeling>};
  return row;
}

}  // namespace pellucid::oit
