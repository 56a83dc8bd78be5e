#include "oit/methods/fourier.h"

#include "oit/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

// Four coefficients to a target: 2 bands + 1 of them.
int target_count(int bands) { return (2 * bands + 1 + 3) / 4; }

class Fourier final : public OitMethod {
 public:
  Fourier(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        bands_(parameters.integer("bands")),
        coefficients_(stage.target("Fourier coefficients", GL_RGBA32F, target_count(bands_))),
        sums_(stage.target("weighted sums of colour", GL_RGBA32F)),
        coefficient_targets_(stage.gl(), {{coefficients_, target_count(bands_)}}),
        sum_target_(stage.gl(), {{sums_}}),
        project_(geometry_program(oit_glsl::fourier_project_frag_glsl(), parameters)),
        weight_(geometry_program(oit_glsl::fourier_weight_frag_glsl(), parameters)),
        composite_(stage.screen_program(oit_glsl::fourier_composite_frag_glsl(),
                                        {{"NORMALIZE", parameters.flag("normalize")}})) {}

  void draw(Frame& frame) override {
    frame.step("project", [&] {
      coefficient_targets_.clear_all(0);
      stage_.begin_pass(coefficient_targets_, {Blend::add});
      stage_.draw_geometry(project_);
    });
    frame.step("weight", [&] {
      sum_target_.clear_all(0);
      coefficients_.bind(0);
      stage_.begin_pass(sum_target_, {Blend::add});
      stage_.draw_geometry(weight_);
    });
    frame.step("composite", [&] {
      sums_.bind(1);
      stage_.begin_pass(frame.picture(), {Blend::replace});
      stage_.draw_screen(composite_);
    });
  }

 private:
  Program geometry_program(std::string_view fragment, const Parameters& parameters) const {
    Program program = stage_.geometry_program(
        fragment, {{"FOURIER_BANDS", bands_}, {"TARGETS", target_count(bands_)}});
    program.set("clamp_alpha", float(parameters.real("clamp")));
    return program;
  }

  const Stage& stage_;
  int bands_;
  Texture coefficients_, sums_;
  Framebuffer coefficient_targets_, sum_target_;
  Program project_, weight_, composite_;
};

constexpr ParameterSpec parameters[] = {
    {.name = "bands",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "5",
     .min = 1,
     .max = 15,
     .unit = "bands",
     .help = "frequencies of the series (m in the paper)"},
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

const MethodRow& fourier_method() {
  static constexpr MethodRow row{
      .name = "fourier",
      .title = "Fourier",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "14 to 19",
      .parameters = parameters,
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "16 ceil((2 bands + 1) / 4) + 16",
      .make = make_oit<Fourier>};
  return row;
}

}  // namespace pellucid
