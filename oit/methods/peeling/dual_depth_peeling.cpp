// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/peeling/dual_depth_peeling.h"

#include <limits>

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class DualDepthPeeling final : public OitMethod {
 public:
  DualDepthPeeling(Stage& stage, const DualDepthPeelingOptions& options)
      : stage_(stage),
        most_peels_(options.peels ? std::uint64_t(*options.peels)
                                  : std::numeric_limits<std::uint64_t>::max() / 2),
        left_(stage.target("last peeled keys", GL_RGBA32UI)),
        ends_(stage.target("nearest and farthest key", GL_RGBA32UI)),
        locks_(stage.target("locks", GL_R32UI)),
        nearest_(stage.target("nearest layer", GL_RGBA32F)),
        farthest_(stage.target("farthest layer", GL_RGBA32F)),
        front_(stage.target("layers from the front", GL_RGBA32F)),
        back_(stage.target("layers from the back", GL_RGBA32F)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        sums_target_(stage.gl(), {{front_}, {back_}, {left_}}),
        query_(stage.gl()),
        peel_(stage.geometry_program(oit_glsl::dual_depth_peeling_peel_frag_glsl())),
        add_(stage.screen_program(oit_glsl::dual_depth_peeling_add_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::dual_depth_peeling_composite_frag_glsl())) {}

  void draw(Frame& frame) override {
    frame.step("clear", [&] {
      sums_target_.clear(0, 0);
      sums_target_.clear(1, 0);
      left_.clear(0);
      locks_.clear(0);
    });
    bool some_left = true;
    for (std::uint64_t peel = 0; peel < most_peels_ && some_left; ++peel) {
      frame.step("peel", [&] { some_left = peel_ends(); });
      if (some_left) frame.step("add", [&] { add_ends(); });
    }
    frame.step("composite", [&] {
      const Resources sums{front_.as_texture(bindings::front_sum_texture),
                           back_.as_texture(bindings::back_sum_texture)};
      stage_.draw_screen({frame.picture(), {Blend::replace}, sums}, composite_);
    });
    if (some_left) frame.stats().dropped = count_left();
  }

  void account(const CountImage& crossings, scene::RenderStats& stats) const override {
    for (const std::uint32_t n : crossings.pixels) {
      stats.stored += std::min<std::uint64_t>(n, 2 * most_peels_);
      stats.truncated += n > 2 * most_peels_;
    }
  }

 private:
  bool peel_ends() const {
    ends_.clear(0);
    const bool found = draw_left(peel_) > 0;
    stage_.gl().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    return found;
  }

  std::uint64_t count_left() const {
    return draw_left(stage_.geometry_program(oit_glsl::dual_depth_peeling_peel_frag_glsl(),
                                             {{"COUNT_LEFT", 1}}));
  }

  // Returns how many fragments passed.
  std::uint64_t draw_left(const GeometryProgram& program) const {
    query_.begin();
    stage_.draw_geometry(
        {no_targets_,
         {Blend::replace},
         {left_.as_texture(bindings::left_keys_texture), ends_.as_image(bindings::ends_image),
          nearest_.as_image(bindings::nearest_layer_image),
          farthest_.as_image(bindings::farthest_layer_image),
          locks_.as_image(bindings::locks_image)}},
        program);
    return query_.end();
  }

  void add_ends() const {
    stage_.draw_screen({sums_target_,
                        {Blend::under, Blend::over, Blend::replace},
                        {ends_.as_texture(bindings::ends_texture),
                         nearest_.as_texture(bindings::nearest_layer_texture),
                         farthest_.as_texture(bindings::farthest_layer_texture)}},
                       add_);
  }

  const Stage& stage_;
  std::uint64_t most_peels_;
  Texture left_, ends_, locks_, nearest_, farthest_, front_, back_;
  Framebuffer no_targets_, sums_target_;
  SampleQuery query_;
  GeometryProgram peel_;
  Program add_, composite_;
};

}  // namespace

const OptionTable<DualDepthPeelingOptions>& dual_depth_peeling_options() {
  static const OptionTable<DualDepthPeelingOptions> table{
      number("peels", &DualDepthPeelingOptions::peels,
             {.min = 1,
              .max = 1e6,
              .unit = "passes",
              .help = "budget of passes, two layers each; not set: all layers"})};
  return table;
}

const scene::MethodRow& dual_depth_peeling_method() {
  static const scene::MethodRow row{
      .name = "dual-depth-peeling",
      .title = "Dual depth peeling",
      .citation =
          "Bavoil and Myers 2008, Order independent transparency with dual depth peeling, NVIDIA",
      .equations = "none; the peeling of both sides in one pass, by keys in place of depths",
      .checked_against = "not recorded",
      .parameters = dual_depth_peeling_options().specs(),
      .promises = {.exact = true,
                   .exact_unless = "peels",
                   .order_independent = true,
                   .convex_hull = true,
                   .fixed_memory = true},
      .bytes_per_pixel = "100",
      .make = make_oit<DualDepthPeeling, dual_depth_peeling_options>};
  return row;
}

}  // namespace pellucid::oit
