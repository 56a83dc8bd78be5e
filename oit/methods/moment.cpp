#include "oit/methods/moment.h"

#include "oit/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

class Moment final : public OitMethod {
 public:
  Moment(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        total_(stage.target("optical depth", GL_R32F)),
        moments_(stage.target("moments 1 to 4", GL_RGBA32F)),
        sums_(stage.target("weighted sums of colour", GL_RGBA32F)),
        sum_target_(stage.gl(), {{sums_}}) {
    const bool six = parameters.text("moments") == "6";
    if (six) {
      more_ = stage.target("moments 5 and 6", GL_RG32F);
      moment_targets_ = {stage.gl(), {{total_}, {moments_}, {more_}}};
    } else {
      moment_targets_ = {stage.gl(), {{total_}, {moments_}}};
    }
    const Defines defines = {{"MOMENTS", six ? 6 : 4}};
    project_ = stage.geometry_program(oit_glsl::moment_project_frag_glsl(), defines);
    weight_ = stage.geometry_program(oit_glsl::moment_weight_frag_glsl(), defines);
    composite_ = stage.screen_program(oit_glsl::moment_composite_frag_glsl());
    for (const Program* program : {&project_, &weight_})
      program->set("clamp_alpha", float(parameters.real("clamp")));
    weight_.set("overestimation", float(parameters.real("overestimation")));
    // The paper's choice for 32-bit moments.
    const double bias = parameters.is_set("bias") ? parameters.real("bias") : six ? 5e-6 : 5e-7;
    weight_.set("bias", float(bias));
  }

  void draw(Frame& frame) override {
    frame.step("project", [&] {
      moment_targets_.clear_all(0);
      stage_.begin_pass(moment_targets_, {Blend::add});
      stage_.draw_geometry(project_);
    });
    frame.step("weight", [&] {
      total_.bind_image(0);
      moments_.bind_image(1);
      if (more_.id()) more_.bind_image(2);
      sum_target_.clear_all(0);
      stage_.begin_pass(sum_target_, {Blend::add});
      stage_.draw_geometry(weight_);
    });
    frame.step("composite", [&] {
      total_.bind(0);
      sums_.bind(1);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
    });
  }

 private:
  const Stage& stage_;
  Texture total_, moments_, more_, sums_;
  Framebuffer moment_targets_, sum_target_;
  Program project_, weight_, composite_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "moments",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "4",
     .choices = "4|6",
     .help = "power moments beyond the zeroth"},
    {.name = "bias",
     .kind = ParameterSpec::Kind::real,
     .default_value = "",
     .min = 0,
     .max = 1,
     .unit = "1",
     .help = "share of a safe distribution mixed in; not set: 5e-7 for 4 moments, 5e-6 for 6"},
    {.name = "overestimation",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0.25",
     .min = 0,
     .max = 1,
     .unit = "1",
     .help = "share of the mass at a fragment that counts as in front of it"},
    {.name = "clamp",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0.9999",
     .min = 0,
     .max = 0.999999,
     .unit = "1",
     .help = "largest opacity; that of 1 has no finite optical depth"}};

}  // namespace

const MethodRow& moment_method() {
  static constexpr MethodRow row{
      .name = "moment",
      .title = "Moments",
      .citation =
          "Muenstermann, Krumpen, Klein and Peters 2018, Moment-based order-independent "
          "transparency, PACMCGIT 1(1)",
      .equations = "power moments 4 and 6 by canonical distributions, derived anew",
      .parameters = parameters,
      // The reconstruction amplifies roundings of the moments by up to 1 / bias.
      .promises = {.order_spread = 0.05, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "36 (4 moments) or 44 (6)",
      .make = make_oit<Moment>};
  return row;
}

}  // namespace pellucid
