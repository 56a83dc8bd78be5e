// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/fourier/fourier.h"

#include <fmt/format.h>

#include "core/error.h"
#include "oit/optical_depth/series_readback.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class Fourier final : public SummingMethod {
 public:
  Fourier(Stage& stage, const FourierOptions& options, const FragmentOpacity& opacity = {})
      : bands_(options.bands),
        subset_(options.series.subset),
        margin_(float(options.series.margin)),
        passes_(stage, {target(options)}, weight_program(stage, options, opacity),
                stage.screen_program(oit_glsl::fourier_composite_frag_glsl(),
                                     {{"NORMALIZE", options.normalize}})),
        projection_(stage, passes_.coefficients(0), bands_, options.series, {}, opacity) {}

  int rounds() const override { return 2; }
  std::vector<SumTarget> targets(int round) const override { return passes_.targets(round); }
  void sum(int round, Frame& frame) override {
    if (round == 1) return passes_.weight(frame);
    frame.step("project", [&] { projection_.project(); });
  }
  void composite(Frame& frame) override { passes_.composite(frame); }
  // Every n-th primitive of a part is not one of the whole's every n-th.
  void check_parts() const override {
    if (subset_ > 1)
      throw InputError(fmt::format("subset={}; accepted for sums of parts: 1", subset_));
  }

  std::optional<scene::RaySeries> ray_series(scene::RaySum sum, int x, int y,
                                             std::span<const double> d) const override {
    if (sum != scene::RaySum::optical_depth) return std::nullopt;
    return read_series(passes_.coefficients(0), bands_, margin_, x, y, d);
  }

 private:
  static GeometryProgram weight_program(const Stage& stage, const FourierOptions& options,
                                        const FragmentOpacity& opacity) {
    return fourier_program(stage, oit_glsl::fourier_weight_frag_glsl(),
                           {{"BANDS", options.bands},
                            {"PRECISION", options.series.precision},
                            {"MIDDLE", options.series.at == SeriesValue::middle}},
                           options.series, opacity);
  }

  static OpticalDepthPasses::Target target(const FourierOptions& options) {
    const auto [format, layers] = fourier_target(options.bands, options.series);
    return {"Fourier coefficients", format, layers};
  }

  int bands_, subset_;
  float margin_;
  OpticalDepthPasses passes_;
  FourierProjection projection_;
};

}  // namespace

std::unique_ptr<OitMethod> make_fourier(Stage& stage, const FourierOptions& options,
                                        const FragmentOpacity& opacity) {
  return std::make_unique<Fourier>(stage, options, opacity);
}

const OptionTable<FourierOptions>& fourier_options() {
  static const OptionTable<FourierOptions> table{
      number("bands", &FourierOptions::bands,
             {.min = 1,
              .max = 64,
              .unit = "bands",
              .help = "frequencies of the series (m in the paper); beyond 15 each 16 more take "
                      "another pass"}),
      normalize_option(&FourierOptions::normalize),
      part(&FourierOptions::series, series_options())};
  return table;
}

const scene::MethodRow& fourier_method() {
  static const scene::MethodRow row{
      .name = "fourier",
      .title = "Fourier",
      .citation =
          "Baeza Rojo, Gross and Guenther 2019, Fourier opacity optimization for scalable "
          "exploration, TVCG",
      .equations = "14 to 19",
      .checked_against = "the paper",
      .parameters = fourier_options().specs(),
      // Sums of n float terms in another order differ by n roundings at most; the exponential of
      // tau makes that n roundings of tau.
      .promises = {.order_spread = 1e-3,
                   .convex_hull = true,
                   .fixed_memory = true,
                   .adds_up = true,
                   .one_layer_unless = "normalize=off"},
      .bytes_per_pixel = "precision / 2 ceil((2 bands + 1) / 4) + 16",
      .sweep = "bands=1|2|3|5|8|10|15",
      .make = make_oit<Fourier, fourier_options>};
  return row;
}

}  // namespace pellucid::oit
