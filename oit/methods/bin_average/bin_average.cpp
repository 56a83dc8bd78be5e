// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/bin_average/bin_average.h"

#include <fmt/format.h>

#include <algorithm>

#include "oit/gl/bindings.h"
#include "oit/stage/summing_method.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class BinAverage final : public SummingMethod {
 public:
  BinAverage(Stage& stage, const BinAverageOptions& options)
      : stage_(stage),
        bins_(options.bins),
        per_pass_(std::min(options.bins, options.bins_per_pass)),
        sums_(stage.target("sums of bins", GL_RGBA32F, per_pass_)),
        counts_(stage.target("counts of bins", GL_R32UI, per_pass_)),
        locks_(stage.target("locks", GL_R32UI)),
        gathered_(stage.target("composite of bins", GL_RGBA32F)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        gathered_target_(stage.gl(), {{gathered_}}),
        accumulate_(stage.geometry_program(oit_glsl::bin_average_accumulate_frag_glsl(),
                                           {{"BINS", bins_}})),
        gather_(stage.screen_program(oit_glsl::bin_average_gather_frag_glsl())),
        composite_(stage.screen_program(oit_glsl::bin_average_composite_frag_glsl())) {}

  // Each round has the bins of one pass.
  int rounds() const override { return (bins_ + per_pass_ - 1) / per_pass_; }
  bool rounds_are_apart() const override { return true; }
  std::vector<SumTarget> targets(int) const override {
    return {{"sums of bins", &sums_},
            {"counts of bins", &counts_, scene::Combine::add, SumTarget::Numbers::counts}};
  }
  void sum(int round, Frame& frame) override {
    frame.step("accumulate", [&] { accumulate(round * per_pass_, bins_of(round)); });
  }
  void close(int round, Frame& frame) override {
    if (round == 0) gathered_target_.clear_all(0);
    frame.step("gather", [&] { gather(bins_of(round)); });
  }
  void composite(Frame& frame) override {
    frame.step("composite", [&] {
      const Resource gathered = gathered_.as_texture(bindings::gathered_bins_texture);
      stage_.draw_screen({frame.picture(), {Blend::replace}, gathered}, composite_);
    });
  }

  std::vector<std::string> explain() const override {
    return {fmt::format(
        "bins: {} in {} passes over the scene, {} at once; all in one pass would "
        "take {} bytes",
        bins_, rounds(), per_pass_, (20 * std::uint64_t(bins_) + 20) * stage_.pixel_count())};
  }

 private:
  int bins_of(int round) const { return std::min(per_pass_, bins_ - round * per_pass_); }

  Resources bins() const {
    return {sums_.as_image(bindings::bin_sums_image), counts_.as_image(bindings::bin_counts_image)};
  }

  void accumulate(int first, int here) {
    locks_.clear(0);
    counts_.clear(0);
    accumulate_.set("first_bin", first);
    accumulate_.set("bins_here", here);
    const Resource locks = locks_.as_image(bindings::locks_image);
    stage_.draw_geometry({no_targets_, {Blend::replace}, bins() + locks}, accumulate_);
    stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }

  void gather(int here) {
    gather_.set("bins_here", here);
    stage_.draw_screen({gathered_target_, {Blend::under}, bins()}, gather_);
    stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  }

  Stage& stage_;
  int bins_, per_pass_;
  Texture sums_, counts_, locks_, gathered_;
  Framebuffer no_targets_, gathered_target_;
  GeometryProgram accumulate_;
  Program gather_, composite_;
};

}  // namespace

const OptionTable<BinAverageOptions>& bin_average_options() {
  static const OptionTable<BinAverageOptions> table{
      number("bins", &BinAverageOptions::bins,
             {.min = 1, .max = 65536, .unit = "bins", .help = "equal parts of the depth range"}),
      number("bins-per-pass", &BinAverageOptions::bins_per_pass,
             {.min = 1,
              .max = 1024,
              .unit = "bins",
              .help = "kept at once, 20 bytes each and pixel; more bins take more passes"})};
  return table;
}

const scene::MethodRow& bin_average_method() {
  static const scene::MethodRow row{
      .name = "bin-average",
      .title = "Averages of bins",
      .citation =
          "Tian and Guenther, Progressive Rendering of Transparent Integral Surfaces, additional "
          "material, section 2.2; after Bavoil et al. 2007, Multi-fragment effects on the GPU "
          "using the k-buffer, I3D",
      .equations = "averages within bins, bins front to back (unnumbered)",
      .checked_against =
          "the additional material of Tian and Guenther; Bavoil et al. 2007 was not "
          "at hand",
      .parameters = bin_average_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most.
      .promises = {.order_spread = 1e-4,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true},
      .bytes_per_pixel = "20 bins-per-pass + 20",
      .sweep = "bins=50|200|1000",
      .make = make_oit<BinAverage, bin_average_options>};
  return row;
}

}  // namespace pellucid::oit
