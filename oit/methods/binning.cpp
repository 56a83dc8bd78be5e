#include "oit/methods/binning.h"

#include "oit/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

class Binning final : public OitMethod {
 public:
  Binning(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        bins_(stage.target("bins of optical depth", GL_R32UI, parameters.integer("bins"))),
        sums_(stage.target("weighted sums of colour", GL_RGBA32F)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        sum_target_(stage.gl(), {{sums_}}) {
    const Defines defines = {{"BINS", parameters.integer("bins")},
                             {"LINEAR", parameters.text("mode") == "linear"},
                             {"NORMALIZE", parameters.flag("normalize")}};
    project_ = stage.geometry_program(oit_glsl::binning_project_frag_glsl(), defines);
    accumulate_ = stage.screen_program(oit_glsl::binning_accumulate_frag_glsl(), defines);
    weight_ = stage.geometry_program(oit_glsl::binning_weight_frag_glsl(), defines);
    composite_ = stage.screen_program(oit_glsl::binning_composite_frag_glsl(), defines);
    for (const Program* program : {&project_, &weight_})
      program->set("clamp_alpha", float(parameters.real("clamp")));
  }

  void draw(Frame& frame) override {
    frame.step("project", [&] { project(); });
    frame.step("accumulate", [&] {
      stage_.draw_screen(accumulate_);
      finish_stores();
    });
    frame.step("weight", [&] {
      sum_target_.clear_all(0);
      stage_.begin_pass(sum_target_, {Blend::add});
      stage_.draw_geometry(weight_);
    });
    frame.step("composite", [&] {
      sums_.bind(0);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
    });
  }

 private:
  void project() const {
    bins_.clear(0);
    bins_.bind_image(0);
    stage_.begin_pass(no_targets_, {Blend::replace});
    stage_.draw_geometry(project_);
    finish_stores();
  }

  void finish_stores() const { stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT); }

  const Stage& stage_;
  Texture bins_, sums_;
  Framebuffer no_targets_, sum_target_;
  Program project_, accumulate_, weight_, composite_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "bins",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "11",
     .min = 1,
     .max = 1024,
     .unit = "bins",
     .help = "equal parts of the depth range"},
    {.name = "mode",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "linear",
     .choices = "constant|linear",
     .help = "how the optical depth is read within a bin"},
    {.name = "normalize",
     .kind = ParameterSpec::Kind::flag,
     .default_value = "on",
     .choices = "on|off",
     .help = "on: Eq. 19; off: Eq. 15, whose colours may leave their convex hull"},
    {.name = "clamp",
     .kind = ParameterSpec::Kind::real,
     .default_value = "0.9999",
     .min = 0,
     .max = 0.999999,
     .unit = "1",
     .help = "largest opacity; Eq. 13 divides by 1 - alpha"}};

}  // namespace

const MethodRow& binning_method() {
  static constexpr MethodRow row{
      .name = "binning",
      .title = "Binning",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG, section 5.3",
      .equations = "14, 15, 18, 19 over a histogram of depth",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "4 bins + 16",
      .make = make_oit<Binning>};
  return row;
}

}  // namespace pellucid
