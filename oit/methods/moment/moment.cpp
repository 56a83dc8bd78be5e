// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/moment/moment.h"

#include <numbers>

#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// Of the circle that depths are put on, in radians: from the nearest to the farthest. The rest, a
// twentieth of a turn, keeps the farthest from being taken for the nearest.
constexpr double angle_range = 1.9 * std::numbers::pi;

/// The paper's choice for 4, 6 and 8 numbers of 32 bits.
constexpr double power_bias[] = {5e-7, 5e-6, 5e-5}, trigonometric_bias[] = {4e-7, 8e-7, 1.5e-6};

bool trigonometric(const MomentOptions& options) {
  return options.basis == MomentBasis::trigonometric;
}

double bias(const MomentOptions& options) {
  const auto& usual = trigonometric(options) ? trigonometric_bias : power_bias;
  return options.bias.value_or(usual[options.moments / 2 - 2]);
}

std::vector<OpticalDepthPasses::Target> moments(const MomentOptions& options) {
  std::vector<OpticalDepthPasses::Target> targets = {{"optical depth and nearness", GL_RG32F},
                                                     {"moments 1 to 4", GL_RGBA32F}};
  if (options.moments == 6) targets.push_back({"moments 5 and 6", GL_RG32F});
  if (options.moments == 8) targets.push_back({"moments 5 to 8", GL_RGBA32F});
  return targets;
}

class Moment final : public SummingMethod {
 public:
  Moment(Stage& stage, const MomentOptions& options)
      : stage_(stage),
        project_(geometry_program(oit_glsl::moment_project_frag_glsl(), options)),
        prepare_(with_uniforms(
            stage.screen_program(oit_glsl::moment_prepare_frag_glsl(), defines(options)), options)),
        passes_(stage, moments(options),
                geometry_program(oit_glsl::moment_weight_frag_glsl(), options),
                stage.screen_program(oit_glsl::moment_composite_frag_glsl())),
        moment_targets_(targets(options)),
        no_targets_(stage.gl(), stage.width(), stage.height()) {}

  int rounds() const override { return 2; }
  std::vector<SumTarget> targets(int round) const override { return passes_.targets(round); }
  void sum(int round, Frame& frame) override {
    if (round == 1) return passes_.weight(frame);
    frame.step("project", [&] {
      moment_targets_.clear_all(0);
      stage_.draw_geometry({moment_targets_, {Blend::add}}, project_);
    });
  }
  void close(int round, Frame& frame) override {
    if (round == 1) return;
    frame.step("prepare", [&] {
      stage_.draw_screen({no_targets_, {Blend::replace}, passes_.coefficient_images()}, prepare_);
      stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    });
  }
  void composite(Frame& frame) override { passes_.composite(frame); }

 private:
  static Defines defines(const MomentOptions& options) {
    Defines defines = {{"MOMENTS", options.moments}};
    if (trigonometric(options)) defines.emplace_back("TRIGONOMETRIC", 1);
    return defines;
  }
  template <class AnyProgram>
  static AnyProgram with_uniforms(AnyProgram program, const MomentOptions& options) {
    program.set_if_used("angle_range", float(angle_range));
    program.set_if_used("overestimation", float(options.overestimation));
    program.set_if_used("bias", float(bias(options)));
    return program;
  }
  GeometryProgram geometry_program(std::string_view fragment, const MomentOptions& options) const {
    return with_uniforms(
        clamped_geometry_program(stage_, fragment, defines(options), options.clamp), options);
  }

  Framebuffer targets(const MomentOptions& options) const {
    const auto target = [&](int i) { return Framebuffer::Attachment{passes_.coefficients(i)}; };
    if (options.moments > 4) return {stage_.gl(), {target(0), target(1), target(2)}};
    return {stage_.gl(), {target(0), target(1)}};
  }

  const Stage& stage_;
  GeometryProgram project_;
  Program prepare_;
  OpticalDepthPasses passes_;
  Framebuffer moment_targets_, no_targets_;
};

}  // namespace

const OptionTable<MomentOptions>& moment_options() {
  static const OptionTable<MomentOptions> table{
      choice("moments", &MomentOptions::moments, {{"4", 4}, {"6", 6}, {"8", 8}},
             "numbers beyond the zeroth moment"),
      choice("basis", &MomentOptions::basis,
             {{"power", MomentBasis::power}, {"trigonometric", MomentBasis::trigonometric}},
             "powers of depth, or cosines and sines of 2, 3 or 4 angles"),
      number("bias", &MomentOptions::bias,
             {.min = 0,
              .max = 1,
              .unit = "1",
              .help = "share of a safe distribution mixed in; not set: 5e-7, 5e-6, 5e-5 for 4, 6, "
                      "8 powers, 4e-7, 8e-7, 1.5e-6 for as many cosines and sines"}),
      number("overestimation", &MomentOptions::overestimation,
             {.min = 0,
              .max = 1,
              .unit = "1",
              .help = "share of the mass at a fragment that counts as in front of it"}),
      number("clamp", &MomentOptions::clamp,
             {.min = 0,
              .max = 0.999999,
              .unit = "1",
              .help = "largest opacity; that of 1 has no finite optical depth"})};
  return table;
}

const scene::MethodRow& moment_method() {
  static const scene::MethodRow row{
      .name = "moment",
      .title = "Moments",
      .citation =
          "Muenstermann, Krumpen, Klein and Peters 2018, Moment-based order-independent "
          "transparency, PACMCGIT 1(1)",
      .equations =
          "4, 6, 8 power and 2, 3, 4 trigonometric moments by canonical distributions, derived "
          "anew",
      .checked_against =
          "theory of canonical representations, derived anew, and public ports of the "
          "authors' code for bias and overestimation; the paper was not at hand",
      .parameters = moment_options().specs(),
      // The reconstruction amplifies roundings of the moments by up to 1 / bias.
      .promises = {.order_spread = 0.05,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true,
                   // Moments of the depths are nearly dependent on each other, and what they tell
                   // changes by up to 4e-3 with a rounding of the depths (docs/methods/moment.md).
                   .change_by_rounding = 5e-3f},
      .bytes_per_pixel = "40 (4 moments), 48 (6) or 56 (8)",
      .sweep = "moments=4|6|8,basis=power|trigonometric",
      .make = make_oit<Moment, moment_options>};
  return row;
}

}  // namespace pellucid::oit
