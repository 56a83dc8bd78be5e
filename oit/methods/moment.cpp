#include "oit/methods/moment.h"

#include "oit/optical_depth_passes.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

bool six_moments(const Parameters& parameters) { return parameters.text("moments") == "6"; }

std::vector<OpticalDepthPasses::Target> moments(const Parameters& parameters) {
  std::vector<OpticalDepthPasses::Target> targets = {{"optical depth", GL_R32F},
                                                     {"moments 1 to 4", GL_RGBA32F}};
  if (six_moments(parameters)) targets.push_back({"moments 5 and 6", GL_RG32F});
  return targets;
}

// The paper's choice for 32-bit moments, if not set.
double bias(const Parameters& parameters) {
  if (parameters.is_set("bias")) return parameters.real("bias");
  return six_moments(parameters) ? 5e-6 : 5e-7;
}

class Moment final : public OitMethod {
 public:
  Moment(Stage& stage, const Parameters& parameters)
      : stage_(stage),
        project_(geometry_program(oit_glsl::moment_project_frag_glsl(), parameters)),
        passes_(stage, moments(parameters),
                geometry_program(oit_glsl::moment_weight_frag_glsl(), parameters),
                stage.screen_program(oit_glsl::moment_composite_frag_glsl())),
        moment_targets_(targets(parameters)) {}

  void draw(Frame& frame) override {
    frame.step("project", [&] {
      passes_.begin_sum(moment_targets_);
      stage_.draw_geometry(project_);
    });
    passes_.weight_and_composite(frame);
  }

 private:
  GeometryProgram geometry_program(std::string_view fragment, const Parameters& parameters) const {
    GeometryProgram program = clamped_geometry_program(
        stage_, fragment, {{"MOMENTS", parameters.integer("moments")}}, parameters);
    program.set("overestimation", float(parameters.real("overestimation")));
    program.set("bias", float(bias(parameters)));
    return program;
  }

  Framebuffer targets(const Parameters& parameters) const {
    const auto target = [&](int i) { return Framebuffer::Attachment{passes_.coefficients(i)}; };
    if (six_moments(parameters)) return {stage_.gl(), {target(0), target(1), target(2)}};
    return {stage_.gl(), {target(0), target(1)}};
  }

  const Stage& stage_;
  GeometryProgram project_;
  OpticalDepthPasses passes_;
  Framebuffer moment_targets_;
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
      .sweep = "moments=4|6",
      .make = make_oit<Moment>};
  return row;
}

}  // namespace pellucid
