// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/pictures/image_file.h"
#include "compare/pictures/ssim.h"
#include "core/error.h"
#include "core/options/names.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

bool finite(const Rgba& p) {
  return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.a);
}

void check_finite(std::string_view which, const Image& image) {
  const auto bad = std::find_if_not(image.pixels.begin(), image.pixels.end(), finite);
  if (bad == image.pixels.end()) return;
  const auto index = bad - image.pixels.begin();
  throw InputError(fmt::format(
      "{} picture: {} pixels are not finite, the first at ({}, {}); accepted: finite values", which,
      count_not_finite(image), index % image.width, index / image.width));
}

void check_pair(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw InputError(fmt::format("test picture: {}×{} pixels; accepted: {}×{} as the reference",
                                 test.width, test.height, reference.width, reference.height));
  if (reference.pixels.empty()) throw InputError("reference picture: it has no pixels");
  check_finite("reference", reference);
  check_finite("test", test);
}

/// Sum of squares, and the largest difference, of a run of pixels.
struct Difference {
  double squares = 0;
  double largest = 0;
  std::size_t where = 0;

  void add(const Rgba& a, const Rgba& b, std::size_t index) {
    for (int c = 0; c < 3; ++c) {
      const double d = double(b[c]) - a[c];
      squares += d * d;
      if (std::abs(d) > largest) {
        largest = std::abs(d);
        where = index;
      }
    }
  }
};

Difference join(const Difference& left, const Difference& right) {
  Difference sum = right.largest > left.largest ? right : left;
  sum.squares = left.squares + right.squares;
  return sum;
}

/// The same to the last bit for any number of threads: the tree of sums depends on the size alone.
Difference difference(const Image& reference, const Image& test) {
  using Range = tbb::blocked_range<std::size_t>;
  return parallel_sum(
      Range(0, reference.pixels.size(), 1 << 14), Difference{},
      [&](const Range& range, Difference sum) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          sum.add(reference.pixels[i], test.pixels[i], i);
        return sum;
      },
      join);
}

PicturePair pair_of(const Image& reference, const Image& test) {
  check_pair(reference, test);
  const Difference d = difference(reference, test);
  return {reference,
          test,
          d.squares / (3.0 * double(reference.pixels.size())),
          {d.largest, int(d.where % reference.width), int(d.where / reference.width)}};
}

std::optional<double> root_mean_square(const PicturePair& pair) {
  return std::sqrt(pair.mean_square);
}

std::optional<double> decibels(const PicturePair& pair) {
  return -20 * std::log10(*root_mean_square(pair));
}

std::optional<double> similarity(const PicturePair& pair) {
  if (std::min(pair.test.width, pair.test.height) < ssim_window) return std::nullopt;
  return mean_ssim(pair.reference, pair.test);
}

std::optional<double> largest(const PicturePair& pair) { return pair.max_error.value; }

constexpr Shown nowhere = {};
constexpr Shown in_report = {.report = true};
constexpr Shown in_tables = {.tables = true, .report = true};

constexpr Shown everywhere(TradeOff role = TradeOff::none) {
  return {.tables = true, .report = true, .card = true, .sweeps = true, .role = role};
}

// The first three lead the columns of results.csv.
constexpr MetricRow rows[] = {
    {"rmse", "Root mean square error", "RMSE", "sqrt(mean (x - y)²) over all RGB values", "", "1",
     Better::lower, NumberStyle::scientific, root_mean_square, everywhere(TradeOff::error)},
    {"ssim", "Structural similarity", "SSIM",
     "11×11 Gaussian window, σ = 1.5, K₁ = 0.01, K₂ = 0.03, L = 1, population covariance; mean "
     "over RGB and over the pixels whose window lies inside",
     "Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment. IEEE TIP 13(4), 2004", "1",
     Better::higher, NumberStyle::similarity, similarity, everywhere(), in_report},
    {"psnr", "Peak signal to noise ratio", "PSNR", "20 log10(1 / RMSE)", "", "dB", Better::higher,
     NumberStyle::decibels, decibels, in_tables, nowhere, true},
    {"max_error", "Largest error", "Max error", "max |x - y| over all RGB values, and its pixel",
     "", "1", Better::lower, NumberStyle::scientific, largest, in_report}};

}  // namespace

std::span<const MetricRow> metrics() { return rows; }

std::string heading(const MetricRow& metric) { return heading(metric.symbol, metric.style); }

const std::optional<double>& Metrics::of(std::string_view name) const {
  return values_[std::size_t(&find_row("metric", name, rows) - rows)];
}

std::optional<double>& Metrics::of(std::string_view name) {
  return values_[std::size_t(&find_row("metric", name, rows) - rows)];
}

std::size_t count_not_finite(const Image& image) {
  return std::size_t(std::count_if(image.pixels.begin(), image.pixels.end(),
                                   [](const Rgba& pixel) { return !finite(pixel); }));
}

double rmse(const Image& reference, const Image& test) {
  return *root_mean_square(pair_of(reference, test));
}

double psnr(const Image& reference, const Image& test) {
  return *decibels(pair_of(reference, test));
}

MaxError max_error(const Image& reference, const Image& test) {
  return pair_of(reference, test).max_error;
}

std::optional<double> ssim(const Image& reference, const Image& test) {
  return similarity(pair_of(reference, test));
}

Metrics metrics_of(const Image& reference, const Image& test) {
  const PicturePair pair = pair_of(reference, test);
  Metrics measured;
  for (std::size_t row = 0; row < std::size(rows); ++row) measured[row] = rows[row].measure(pair);
  measured.max_error_x = pair.max_error.x;
  measured.max_error_y = pair.max_error.y;
  return measured;
}

Comparison compare_images(const Image& reference, const Image& test) {
  return {metrics_of(reference, test),
          metrics_of(displayed_values(reference), displayed_values(test))};
}

}  // namespace pellucid::compare
