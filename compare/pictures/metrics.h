// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/pictures/number_style.h"
#include "core/raster.h"

namespace pellucid::compare {

/// A MaxError is the largest absolute difference of any red, green or blue value, and the first
/// pixel that has it (row 0 is the top).
struct MaxError {
  double value = 0;
  int x = 0, y = 0;  // from the top left
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

/// A PicturePair is two pictures of one size, all finite, with what several metrics are made of
/// computed once.
struct PicturePair {
  const Image& reference;
  const Image& test;
  double mean_square = 0;  // of the difference, over all RGB values
  MaxError max_error = {};
};

/// A MetricRow is one row of the table of metrics: command line, study files, tables, JSON, report
/// and `list` read it. A metric is a function of two pictures and its row.
struct MetricRow {
  std::string_view name;    // in JSON, CSV and study files
  std::string_view title;   // for people
  std::string_view symbol;  // of a narrow column: "PSNR"
  std::string_view definition;
  std::string_view citation;
  std::string_view unit;
  Better better;
  NumberStyle style;
  std::optional<double> (*measure)(const PicturePair&);
  Shown shown;                       // of the float pictures
  Shown shown_displayed = {};        // of the 8-bit values
  bool infinite_when_equal = false;  // JSON has no infinity: it writes null
};

/// The table of metrics; the first three lead the columns of results.csv.
std::span<const MetricRow> metrics();

/// Returns the symbol with the unit: "PSNR [dB]".
std::string heading(const MetricRow& metric);

/// Metrics holds the values of metrics() for one pair of pictures.
class Metrics {
 public:
  Metrics() : values_(metrics().size()) {}

  /// By the row's place in metrics(); nothing where the pictures have no such number.
  const std::optional<double>& operator[](std::size_t row) const { return values_[row]; }
  std::optional<double>& operator[](std::size_t row) { return values_[row]; }
  /// By the row's name. Throws InputError for an unknown one.
  const std::optional<double>& of(std::string_view name) const;
  std::optional<double>& of(std::string_view name);

  int max_error_x = 0, max_error_y = 0;  // the pixel of the largest error, from the top left

 private:
  std::vector<std::optional<double>> values_;
};

/// Computes all metrics. Throws as rmse() does.
Metrics metrics_of(const Image& reference, const Image& test);

/// A Comparison has the metrics of the float pictures, and those of the 8-bit values that a screen
/// shows of them.
struct Comparison {
  Metrics linear;
  Metrics displayed;
};

/// Compares two pictures in both ways. Throws as rmse() does.
Comparison compare_images(const Image& reference, const Image& test);

/// Counts the pixels with a value that is infinite or not a number.
std::size_t count_not_finite(const Image& image);

}  // namespace pellucid::compare
