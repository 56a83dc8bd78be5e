// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/pictures/number_style.h"
#include "compare/pictures/picture_pair.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Returns the root mean square of all red, green and blue differences. As all metrics here it
/// takes values as they are (nominal range [0, 1], HDR not clamped, but by FLIP), sums in double,
/// and throws InputError as PicturePair does.
double rmse(const Image& reference, const Image& test);

/// Returns 20 log10(1 / RMSE), in dB; infinite for equal pictures. Throws as rmse() does.
double psnr(const Image& reference, const Image& test);

/// Returns the largest difference and where it is. Throws as rmse() does.
MaxError max_error(const Image& reference, const Image& test);

/// Returns the mean structural similarity (compare/pictures/ssim.h). Nothing when a side is below
/// 11 pixels: then no pixel's window lies inside. Throws as rmse() does.
std::optional<double> ssim(const Image& reference, const Image& test);

/// Returns the multi-scale structural similarity (compare/pictures/ms_ssim.h). Nothing when a side
/// is below 176 pixels. Throws as rmse() does.
std::optional<double> ms_ssim(const Image& reference, const Image& test);

/// Returns the mean of LDR-FLIP's map (compare/pictures/flip.h). Throws as rmse() does.
double flip(const Image& reference, const Image& test);

/// A MetricCard says what went into a number: two of one name agree only if these do.
struct MetricCard {
  std::string_view space;     // of the values: "display values as they are"
  std::string_view channels;  // and how they are joined
  std::string_view window;    // of pixels around each; "none"
};

/// A MetricRow is one row of the table of metrics: command line, study files, tables, JSON, report
/// and `list` read it. A metric is a function of two pictures, over a region of them.
struct MetricRow {
  std::string_view name;    // in JSON, CSV and study files
  std::string_view title;   // for people
  std::string_view symbol;  // of a narrow column: "PSNR"
  std::string_view definition;
  std::string_view citation;
  std::string_view unit;
  Better better;  // of a signed error neither: the nearer to 0
  NumberStyle style;
  std::optional<double> (*measure)(const PicturePair&, Region);
  MetricCard card;
  Shown shown;                       // of the float pictures
  Shown shown_displayed = {};        // of the 8-bit values
  bool displayed = false;            // measured of the 8-bit values too
  bool infinite_when_equal = false;  // JSON has no infinity: it writes null
  bool on_request = false;           // no column: measured when it is named
  Region region = Region::all;
};

/// The table of metrics; the first three lead the columns of results.csv. Those over the whole
/// picture come first; then the same over the covered pixels, "rmse_covered", and over those with
/// equal layers, "rmse_equal"; last those that are measured on request.
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
  std::optional<double> covered;         // share of the pixels with a layer in the reference

 private:
  std::vector<std::optional<double>> values_;
};

/// Returns the largest difference in opacity, which no metric counts: they are of colours.
double max_alpha_error(const Image& reference, const Image& test);

/// A Comparison has the metrics of the float pictures, and those of the 8-bit values that a screen
/// shows of them.
struct Comparison {
  Metrics linear;
  Metrics displayed;
};

/// Measures a pair of pictures: by the metrics of these names, or by all but those on request if
/// there are none. Throws InputError for an unknown name.
Metrics metrics_of(const PicturePair& pair, std::span<const std::string> names = {});

/// Measures the pictures as they are, and those metrics that are `displayed` of the 8-bit values.
/// Throws as metrics_of() does.
Comparison compare_pair(const PicturePair& pair, std::span<const std::string> names = {});

/// Compares two pictures in both ways. Throws as PicturePair does.
Comparison compare_images(const Image& reference, const Image& test,
                          const PairRegions& regions = {});

}  // namespace pellucid::compare
