// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "compare/pictures/ms_ssim.h"
#include "compare/pictures/other_ssim.h"

namespace pellucid::compare {
namespace {

/// The shorter side, in pixels.
int side(const PicturePair& pair) { return std::min(pair.test().width, pair.test().height); }

std::optional<double> root_mean_square(const PicturePair& pair, Region region) {
  const auto& errors = pair.errors(region);
  return errors ? std::optional(std::sqrt(errors->mean_square)) : std::nullopt;
}

std::optional<double> decibels(const PicturePair& pair, Region region) {
  const std::optional<double> error = root_mean_square(pair, region);
  return error ? std::optional(-20 * std::log10(*error)) : std::nullopt;
}

std::optional<double> similarity(const PicturePair& pair, Region region) {
  return pair.ssim() ? pair.mean(pair.ssim()->map, region, ssim_margin) : std::nullopt;
}

std::optional<double> multi_scale(const PicturePair& pair, Region) {
  if (side(pair) < ms_ssim_side || pair.is_masked()) return std::nullopt;
  return mean_ms_ssim(pair.reference(), pair.test(), *pair.ssim());
}

std::optional<double> seen(const PicturePair& pair, Region region) {
  return pair.mean(pair.flip(), region);
}

std::optional<double> largest(const PicturePair& pair, Region region) {
  const auto& errors = pair.errors(region);
  return errors ? std::optional(errors->max.value) : std::nullopt;
}

template <double ErrorPercentiles::*of>
std::optional<double> percentile(const PicturePair& pair, Region region) {
  const auto& percentiles = pair.percentiles(region);
  return percentiles ? std::optional(*percentiles.*of) : std::nullopt;
}

template <int channel>
std::optional<double> bias(const PicturePair& pair, Region region) {
  const auto& errors = pair.errors(region);
  return errors ? std::optional(errors->mean[channel]) : std::nullopt;
}

std::optional<double> scikit_image(const PicturePair& pair, Region) {
  if (side(pair) < box_ssim_window || pair.is_masked()) return std::nullopt;
  return box_ssim(pair.reference(), pair.test());
}

std::optional<double> luma_similarity(const PicturePair& pair, Region) {
  if (side(pair) < ssim_window || pair.is_masked()) return std::nullopt;
  return ssim_scores(luma8(pair.reference()), luma8(pair.test())).similarity[0];
}

constexpr Shown nowhere = {};
constexpr Shown in_report = {.report = true};
constexpr Shown in_tables = {.tables = true, .report = true};
constexpr Shown on_cards = {.report = true, .card = true};

constexpr Shown everywhere(TradeOff role = TradeOff::none) {
  return {.tables = true, .report = true, .card = true, .sweeps = true, .role = role};
}

constexpr std::string_view as_they_are = "as they are, not clamped";
constexpr MetricCard plain = {as_they_are, "mean over R, G, B", "none"};
constexpr MetricCard largest_channel = {as_they_are, "the largest of R, G, B", "none"};
constexpr MetricCard one_channel = {as_they_are, "one", "none"};
constexpr MetricCard gaussian = {as_they_are, "mean over R, G, B", "11×11 Gaussian, σ = 1.5"};

constexpr std::string_view wang_2004 =
    "Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment. IEEE TIP 13(4), 2004";

constexpr MetricRow bias_row(std::string_view name, std::string_view title, std::string_view symbol,
                             decltype(MetricRow::measure) measure) {
  return {name,    title,       symbol,          "mean (test - reference)",
          "",      "1",         Better::neither, NumberStyle::scientific,
          measure, one_channel, nowhere};
}

/// Over the whole picture; the first three lead the columns of results.csv.
constexpr MetricRow whole_rows[] = {
    {"rmse", "Root mean square error", "RMSE", "sqrt(mean (x - y)²) over all RGB values", "", "1",
     Better::lower, NumberStyle::scientific, root_mean_square, plain, everywhere(TradeOff::error),
     nowhere, true},
    {"ssim", "Structural similarity", "SSIM",
     "11×11 Gaussian window, σ = 1.5, K₁ = 0.01, K₂ = 0.03, L = 1, population covariance; mean "
     "over RGB and over the pixels whose window lies inside",
     wang_2004, "1", Better::higher, NumberStyle::similarity, similarity, gaussian, everywhere(),
     in_report, true},
    {"psnr", "Peak signal to noise ratio", "PSNR", "20 log10(1 / RMSE)", "", "dB", Better::higher,
     NumberStyle::decibels, decibels, plain, in_tables, nowhere, true, true},
    {"max_error", "Largest error", "Max error", "max |x - y| over all RGB values, and its pixel",
     "", "1", Better::lower, NumberStyle::scientific, largest, largest_channel, in_report, nowhere,
     true},
    {"p95", "95th percentile of the error", "P95",
     "the least error, of a pixel the largest of RGB, that 95 % of the pixels do not exceed", "",
     "1", Better::lower, NumberStyle::scientific, percentile<&ErrorPercentiles::p95>,
     largest_channel, nowhere},
    {"p99", "99th percentile of the error", "P99",
     "the least error, of a pixel the largest of RGB, that 99 % of the pixels do not exceed", "",
     "1", Better::lower, NumberStyle::scientific, percentile<&ErrorPercentiles::p99>,
     largest_channel, in_report},
    {"flip",
     "Difference seen when the pictures alternate",
     "FLIP",
     "LDR-FLIP at 0.7 m from a display of 0.7 m and 3840 pixels (67 pixels per degree): the mean "
     "of its map",
     "Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference "
     "Evaluator for Alternating Images. PACMCGIT 3(2), 2020",
     "1",
     Better::lower,
     NumberStyle::scientific,
     seen,
     {"as sRGB, clamped to [0, 1]", "HyAB in L*a*b*; edges and points of Y",
      "Gaussians, 21×21 and 19×19"},
     everywhere(),
     nowhere,
     true},
    {"ms_ssim",
     "Multi-scale structural similarity",
     "MS-SSIM",
     "SSIM's factors at five scales, to the powers 0.0448, 0.2856, 0.3001, 0.2363, 0.1333; 2×2 "
     "mean from scale to scale; none below 176 pixels or of a masked picture",
     "Wang, Simoncelli, Bovik: Multi-Scale Structural Similarity for Image Quality Assessment. "
     "Asilomar 2003",
     "1",
     Better::higher,
     NumberStyle::similarity,
     multi_scale,
     {as_they_are, "mean over R, G, B", "11×11 Gaussian, σ = 1.5, at 5 scales"},
     in_report,
     nowhere,
     true},
    bias_row("bias_r", "Mean signed error of red", "Bias, red", bias<0>),
    bias_row("bias_g", "Mean signed error of green", "Bias, green", bias<1>),
    bias_row("bias_b", "Mean signed error of blue", "Bias, blue", bias<2>)};

/// What other programs print under the same names.
constexpr MetricRow request_rows[] = {
    {"ssim_skimage",
     "Structural similarity as scikit-image's default",
     "SSIM, 7×7",
     "structural_similarity(x, y, data_range=1, channel_axis=-1): 7×7 equal weights, sample "
     "covariance",
     "scikit-image 0.19",
     "1",
     Better::higher,
     NumberStyle::similarity,
     scikit_image,
     {as_they_are, "mean over R, G, B", "7×7, equal weights"},
     nowhere,
     nowhere,
     false,
     false,
     true},
    {"ssim_luma8",
     "Structural similarity of 8-bit luma",
     "SSIM, luma",
     "SSIM of round(0.299 R + 0.587 G + 0.114 B) of the 8-bit values, L = 255",
     wang_2004,
     "1",
     Better::higher,
     NumberStyle::similarity,
     luma_similarity,
     {"8-bit values", "luma", "11×11 Gaussian, σ = 1.5"},
     nowhere,
     nowhere,
     false,
     false,
     true}};

/// How the rows over a part of the picture differ from those over all of it.
struct RegionWords {
  Region region;
  std::string_view title, symbol, definition;
};

constexpr RegionWords parts[] = {
    {Region::covered, "where covered", "covered", "over the pixels with a layer in the reference"},
    {Region::equal, "where layers agree", "equal layers",
     "over the pixels with as many layers as the reference"}};

/// Multi-scale SSIM has no map, of which a part could be taken.
bool has_parts(const MetricRow& row) { return row.measure != multi_scale; }

/// Those that show what a picture of mostly background hides.
Shown shown_of_part(const MetricRow& row, Region region) {
  if (region != Region::covered) return nowhere;
  if (row.measure == similarity) return on_cards;
  return row.measure == root_mean_square || row.measure == seen ? in_report : nowhere;
}

/// `texts` keeps what the row refers to.
MetricRow part_row(MetricRow row, const RegionWords& words, std::deque<std::string>& texts) {
  const auto text = [&](std::string_view format, std::string_view a, std::string_view b) {
    return std::string_view(texts.emplace_back(fmt::format(fmt::runtime(format), a, b)));
  };
  row.shown = shown_of_part(row, words.region);
  row.name = text("{}_{}", row.name, name_of(words.region));
  row.title = text("{}, {}", row.title, words.title);
  row.symbol = text("{}, {}", row.symbol, words.symbol);
  row.definition = text("{}, {}", row.definition, words.definition);
  row.shown_displayed = nowhere;
  row.displayed = false;
  row.region = words.region;
  return row;
}

std::vector<MetricRow> make_rows() {
  static std::deque<std::string> texts;
  std::vector<MetricRow> rows(std::begin(whole_rows), std::end(whole_rows));
  for (const RegionWords& words : parts)
    for (const MetricRow& row : whole_rows)
      if (has_parts(row)) rows.push_back(part_row(row, words, texts));
  rows.insert(rows.end(), std::begin(request_rows), std::end(request_rows));
  return rows;
}

}  // namespace

std::span<const MetricRow> metrics() {
  static const std::vector<MetricRow> rows = make_rows();
  return rows;
}

std::string heading(const MetricRow& metric) { return heading(metric.symbol, metric.style); }

}  // namespace pellucid::compare
