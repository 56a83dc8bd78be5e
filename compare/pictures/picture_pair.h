// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "compare/pictures/mask.h"
#include "compare/pictures/ssim.h"

namespace pellucid::compare {

/// A Region says over which pixels a metric is taken: all (of the mask, if there is one), those of
/// them with a layer in the reference, or those with as many layers as in the reference.
enum class Region { all, covered, equal };

/// Returns "all", "covered", "equal".
std::string_view name_of(Region region);

/// A MaxError is the largest absolute difference of any red, green or blue value, and the first
/// pixel that has it (row 0 is the top).
struct MaxError {
  double value = 0;
  int x = 0, y = 0;  // from the top left
};

/// An ErrorSummary is what is known of the differences test - reference over some pixels.
struct ErrorSummary {
  double mean_square = 0;   // over red, green and blue
  ChannelValues mean = {};  // signed, by channel
  MaxError max = {};
};

/// ErrorPercentiles are the least errors, of a pixel the largest in red, green or blue, that so
/// many percent of the pixels do not exceed.
struct ErrorPercentiles {
  double p95 = 0, p99 = 0;
};

/// PairRegions are what tells the pixels of two pictures apart. Whatever is there has their size.
struct PairRegions {
  const Mask* mask = nullptr;  // null: all pixels count
  const CountImage* reference_layers = nullptr;
  const CountImage* test_layers = nullptr;
};

/// A PicturePair is two pictures of one size, all finite, with what several metrics are made of:
/// each is computed when it is first asked for, once, so that a pair is of one thread. It refers to
/// the pictures, the mask and the layers.
class PicturePair {
 public:
  /// Throws InputError when the sizes differ, when there are no pixels, when a value of either
  /// picture is not finite, or when the mask has no pixel.
  PicturePair(const Image& reference, const Image& test, const PairRegions& regions = {});

  const Image& reference() const { return reference_; }
  const Image& test() const { return test_; }
  const PairRegions& regions() const { return regions_; }
  /// Whether a mask keeps some pixels out of every region.
  bool is_masked() const { return regions_.mask; }
  /// The share of the pixels that count which have a layer; nothing without the reference's layers.
  std::optional<double> covered() const;

  /// Nothing where the region is not known or has no pixel.
  const std::optional<ErrorSummary>& errors(Region region) const;
  const std::optional<ErrorPercentiles>& percentiles(Region region) const;
  /// Null when a side is below ssim_window.
  const SsimScores* ssim() const;
  /// Of LDR-FLIP (compare/pictures/flip.h).
  const Raster<float>& flip() const;
  /// Returns the mean of a map (mean_over) over a region's pixels.
  template <class T>
  std::optional<double> mean(const Raster<T>& map, Region region, int margin = 0) const {
    return is_known(region) ? mean_over(map, mask(region), margin) : std::nullopt;
  }

 private:
  bool is_known(Region region) const;
  /// Null: all pixels. The region is known.
  const Mask* mask(Region region) const;
  std::optional<ErrorPercentiles> find_percentiles(Region region) const;

  const Image& reference_;
  const Image& test_;
  PairRegions regions_;
  std::optional<Mask> covered_, equal_;
  mutable std::optional<std::optional<ErrorSummary>> errors_[3];
  mutable std::optional<std::optional<ErrorPercentiles>> percentiles_[3];
  mutable std::optional<SsimScores> ssim_;
  mutable std::optional<Raster<float>> flip_;
};

/// Counts the pixels with a value that is infinite or not a number.
std::size_t count_not_finite(const Image& image);

/// Throws WorkError, "CALL: 3 of its picture's pixels are not finite", where any is: a shader of
/// one's own may divide by 0.
void require_finite(const Image& image, std::string_view call);

}  // namespace pellucid::compare
