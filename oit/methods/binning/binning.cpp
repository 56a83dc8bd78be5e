// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/binning/binning.h"

#include <algorithm>
#include <cmath>

#include "oit/gl/bindings.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class Binning final : public SummingMethod {
 public:
  Binning(Stage& stage, const BinningOptions& options)
      : Binning(stage, options,
                {{"BINS", options.bins},
                 {"LINEAR", options.mode == BinMode::linear},
                 {"NORMALIZE", options.normalize}}) {}

  int rounds() const override { return 2; }
  std::vector<SumTarget> targets(int round) const override {
    return passes_.targets(round, SumTarget::Numbers::bits_of_floats);
  }
  void sum(int round, Frame& frame) override {
    if (round == 1) return passes_.weight(frame);
    frame.step("project", [&] { project(); });
  }
  void close(int round, Frame& frame) override {
    if (round == 1) return;
    frame.step("accumulate", [&] {
      stage_.draw_screen({no_targets_, {Blend::replace}, bins()}, accumulate_);
      finish_stores();
    });
  }
  void composite(Frame& frame) override { passes_.composite(frame); }

  // As the weight pass does it.
  std::optional<scene::RaySeries> ray_series(scene::RaySum sum, int x, int y,
                                             std::span<const double> d) const override {
    if (sum != scene::RaySum::optical_depth) return std::nullopt;
    std::vector<float> tau(std::size_t(bins_) + 1);  // at the bins' edges, from d = 0 on
    static_assert(sizeof(float) == sizeof(std::uint32_t));
    passes_.coefficients(0).read_pixel(x, y, bins_, GL_RED_INTEGER, GL_UNSIGNED_INT,
                                       std::size_t(bins_) * sizeof(float), tau.data() + 1);
    scene::RaySeries result;
    for (const double depth : d) {
      const double at = depth * bins_;
      const std::size_t bin = std::min(std::size_t(at), std::size_t(bins_ - 1));
      const double share = linear_ ? at - double(bin) : 1;
      result.values.push_back(std::lerp(double(tau[bin]), double(tau[bin + 1]), share));
    }
    return result;
  }

 private:
  Binning(Stage& stage, const BinningOptions& options, const Defines& defines)
      : stage_(stage),
        bins_(options.bins),
        linear_(options.mode == BinMode::linear),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        project_(clamped_geometry_program(stage, oit_glsl::binning_project_frag_glsl(), defines,
                                          options.clamp)),
        accumulate_(stage.screen_program(oit_glsl::binning_accumulate_frag_glsl(), defines)),
        passes_(stage, {{"bins of optical depth", GL_R32UI, options.bins}},
                clamped_geometry_program(stage, oit_glsl::binning_weight_frag_glsl(), defines,
                                         options.clamp),
                stage.screen_program(oit_glsl::binning_composite_frag_glsl(), defines)) {}

  Resource bins() const { return passes_.coefficients(0).as_image(bindings::coefficients_image); }

  void project() const {
    passes_.coefficients(0).clear(0);
    stage_.draw_geometry({no_targets_, {Blend::replace}, bins()}, project_);
    finish_stores();
  }

  void finish_stores() const { stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT); }

  const Stage& stage_;
  int bins_;
  bool linear_;
  Framebuffer no_targets_;
  GeometryProgram project_;
  Program accumulate_;
  OpticalDepthPasses passes_;
};

}  // namespace

const OptionTable<BinningOptions>& binning_options() {
  static const OptionTable<BinningOptions> table{
      number("bins", &BinningOptions::bins,
             {.min = 1, .max = 1024, .unit = "bins", .help = "equal parts of the depth range"}),
      choice("mode", &BinningOptions::mode,
             {{"constant", BinMode::constant}, {"linear", BinMode::linear}},
             "how the optical depth is read within a bin"),
      normalize_option(&BinningOptions::normalize), clamp_option(&BinningOptions::clamp)};
  return table;
}

const scene::MethodRow& binning_method() {
  static const scene::MethodRow row{
      .name = "binning",
      .title = "Binning",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG, section 5.3",
      .equations = "14, 15, 18, 19 over a histogram of depth",
      .checked_against = "the paper and its additional material",
      .parameters = binning_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true,
                   .one_layer_unless = "normalize=off"},
      .bytes_per_pixel = "4 bins + 16",
      .sweep = "bins=3|11|50|200",
      .make = make_oit<Binning, binning_options>};
  return row;
}

}  // namespace pellucid::oit
