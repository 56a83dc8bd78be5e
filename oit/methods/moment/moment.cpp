// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/moment/moment.h"

#include <numbers>

#include "oit/optical_depth/optical_depth_passes.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// Of the circle that depths are put on, in radians: from the nearest to the farthest. The rest, a
// twentieth of a turn, keeps the farthest from being taken for the nearest.
constexpr double angle_range = 1.9 * std::numbers::pi;

struct Basis {
  std::string_view name;
  double bias[3];  // the paper's choice for 4, 6 and 8 numbers of 32 bits
};
constexpr Basis bases[] = {{"power", {5e-7, 5e-6, 5e-5}}, {"trigonometric", {4e-7, 8e-7, 1.5e-6}}};

int moment_count(const Parameters& parameters) { return parameters.integer("moments"); }

bool trigonometric(const Parameters& parameters) {
  return parameters.text("basis") == bases[1].name;
}

double bias(const Parameters& parameters) {
  if (parameters.is_set("bias")) return parameters.real("bias");
  return bases[trigonometric(parameters)].bias[moment_count(parameters) / 2 - 2];
}

std::vector<OpticalDepthPasses::Target> moments(const Parameters& parameters) {
  std::vector<OpticalDepthPasses::Target> targets = {{"optical depth", GL_R32F},
                                                     {"moments 1 to 4", GL_RGBA32F}};
  if (moment_count(parameters) == 6) targets.push_back({"moments 5 and 6", GL_RG32F});
  if (moment_count(parameters) == 8) targets.push_back({"moments 5 to 8", GL_RGBA32F});
  return targets;
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
      moment_targets_.clear_all(0);
      stage_.draw_geometry({moment_targets_, {Blend::add}}, project_);
    });
    passes_.weight_and_composite(frame);
  }

 private:
  GeometryProgram geometry_program(std::string_view fragment, const Parameters& parameters) const {
    Defines defines = {{"MOMENTS", moment_count(parameters)}};
    if (trigonometric(parameters)) defines.emplace_back("TRIGONOMETRIC", 1);
    GeometryProgram program =
        clamped_geometry_program(stage_, fragment, std::move(defines), parameters);
    program.set_if_used("angle_range", float(angle_range));
    program.set_if_used("overestimation", float(parameters.real("overestimation")));
    program.set_if_used("bias", float(bias(parameters)));
    return program;
  }

  Framebuffer targets(const Parameters& parameters) const {
    const auto target = [&](int i) { return Framebuffer::Attachment{passes_.coefficients(i)}; };
    if (moment_count(parameters) > 4) return {stage_.gl(), {target(0), target(1), target(2)}};
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
     .choices = "4|6|8",
     .help = "numbers beyond the zeroth moment"},
    {.name = "basis",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "power",
     .choices = "power|trigonometric",
     .help = "powers of depth, or cosines and sines of 2, 3 or 4 angles"},
    {.name = "bias",
     .kind = ParameterSpec::Kind::real,
     .default_value = "",
     .min = 0,
     .max = 1,
     .unit = "1",
     .help = "share of a safe distribution mixed in; not set: 5e-7, 5e-6, 5e-5 for 4, 6, 8 powers, "
             "4e-7, "
             "8e-7, 1.5e-6 for as many cosines and sines"},
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

const scene::MethodRow& moment_method() {
  static constexpr scene::MethodRow row{
      .name = "moment",
      .title = "Moments",
      .citation =
          "Muenstermann, Krumpen, Klein and Peters 2018, Moment-based order-independent "
          "transparency, PACMCGIT 1(1)",
      .equations =
          "4, 6, 8 power and 2, 3, 4 trigonometric moments by canonical distributions, derived "
          "anew",
      .parameters = parameters,
      // The reconstruction amplifies roundings of the moments by up to 1 / bias.
      .promises = {.order_spread = 0.05, .convex_hull = true, .fixed_memory = true},
      .bytes_per_pixel = "36 (4 moments), 44 (6) or 52 (8)",
      .sweep = "moments=4|6|8,basis=power|trigonometric",
      .make = make_oit<Moment>};
  return row;
}

}  // namespace pellucid::oit
