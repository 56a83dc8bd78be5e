// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oit/methods/toy/color_filter.h"

#include "oit/gl/bindings.h"
#include "oit/stage/oit_renderer.h"
#include "toy_glsl.h"

namespace pellucid::oit {
namespace {

class ColorFilter final : public OitMethod {
 public:
  ColorFilter(Stage& stage, const ColorFilterOptions& options)
      : stage_(stage),
        filter_(stage.target("product of filters and transmittances", GL_RGBA32F)),
        target_(stage.gl(), {{filter_}}),
        accumulate_(stage.geometry_program(toy_glsl::color_filter_accumulate_frag_glsl())),
        composite_(stage.screen_program(toy_glsl::color_filter_composite_frag_glsl())) {
    accumulate_.set("strength", float(options.strength));
  }

  void draw(Frame& frame) override {
    frame.step("accumulate", [&] {
      target_.clear_all(1);
      stage_.draw_geometry({target_, {Blend::transmit}}, accumulate_);
    });
    frame.step("composite", [&] {
      stage_.draw_screen(
          {frame.picture(), {Blend::replace}, filter_.as_texture(bindings::own_texture)},
          composite_);
    });
  }

 private:
  const Stage& stage_;
  Texture filter_;
  Framebuffer target_;
  GeometryProgram accumulate_;
  Program composite_;
};

}  // namespace

const OptionTable<ColorFilterOptions>& color_filter_options() {
  static const OptionTable<ColorFilterOptions> table{
      number("strength", &ColorFilterOptions::strength,
             {.min = 0, .max = 1, .unit = "1", .help = "of each layer's colour as a filter"})};
  return table;
}

const scene::MethodRow& color_filter_method() {
  static const scene::MethodRow row{.name = "color-filter",
                                    .title = "Colour filters",
                                    .citation = "none: a toy",
                                    .equations = "see its header",
                                    .checked_against = "its closed form",
                                    .parameters = color_filter_options().specs(),
                                    // A product of n floats in another order differs by n
                                    // roundings at most.
                                    .promises = {.order_spread = 1e-4, .fixed_memory = true},
                                    .bytes_per_pixel = "16",
                                    .make = make_oit<ColorFilter, color_filter_options>};
  return row;
}

}  // namespace pellucid::oit
