// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/raster.h"

namespace pellucid::compare {

/// A MaxError is the largest absolute difference of any red, green or blue value, and the first
/// pixel that has it (row 0 is the top).
struct MaxError {
  double value = 0;
  int x = 0, y = 0;
};

/// Returns the root mean square of all red, green and blue differences. As all metrics here it
/// takes values as they are (nominal range [0, 1], HDR not clamped), sums in double, and throws
/// InputError when the sizes differ, when there are no pixels, or when a value of either picture is
/// not finite.
double rmse(const Image& reference, const Image& test);

/// Returns 20 log10(1 / RMSE), in dB; infinite for equal pictures. Throws as rmse() does.
double psnr(const Image& reference, const Image& test);

/// Returns the largest difference and where it is. Throws as rmse() does.
MaxError max_error(const Image& reference, const Image& test);

/// Returns the mean structural similarity (compare/pictures/ssim.h). Nothing when a side is below
/// 11 pixels: then no pixel's window lies inside. Throws as rmse() does.
std::optional<double> ssim(const Image& reference, const Image& test);

/// Metrics are the values of all metrics for one pair of pictures.
struct Metrics {
  double rmse = 0;
  double psnr = 0;  // dB
  std::optional<double> ssim;
  MaxError max_error;
};

/// Computes all metrics. Throws as rmse() does.
Metrics measure(const Image& reference, const Image& test);

/// A Comparison holds the metrics of the float pictures, and of the 8-bit values that a screen
/// shows of them.
struct Comparison {
  Metrics linear;
  Metrics displayed;
};

/// Computes all metrics of the float pictures and of their displayed values. Throws as rmse() does.
Comparison compare_images(const Image& reference, const Image& test);

/// Returns the number of pixels with a value that is infinite or not a number, A included.
std::size_t count_not_finite(const Image& image);

/// A MetricRow is one row of the table that `list metrics` and the report read.
struct MetricRow {
  std::string_view name;
  std::string_view title;
  std::string_view definition;
  std::string_view citation;
  std::string_view unit;
  bool higher_is_better;
  std::optional<double> (*value)(const Metrics&);
};

/// Returns the table of metrics.
std::span<const MetricRow> metrics();

}  // namespace pellucid::compare
