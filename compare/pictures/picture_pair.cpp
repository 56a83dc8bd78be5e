// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/picture_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "compare/pictures/error_map.h"
#include "compare/pictures/flip.h"
#include "core/error.h"
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

template <class T>
void check_size(std::string_view what, const Raster<T>& raster, const Image& reference) {
  if (raster.width != reference.width || raster.height != reference.height)
    throw InputError(fmt::format("{}: {}×{} pixels; accepted: {}×{} as the reference", what,
                                 raster.width, raster.height, reference.width, reference.height));
}

void check_regions(const Image& reference, const PairRegions& regions) {
  if (regions.mask) check_size("mask", *regions.mask, reference);
  if (regions.mask && count(*regions.mask) == 0)
    throw InputError("mask: no pixel of it counts; accepted: some of a half or more");
  if (regions.reference_layers)
    check_size("reference's layers", *regions.reference_layers, reference);
  if (regions.test_layers) check_size("test's layers", *regions.test_layers, reference);
}

/// Of a run of pixels.
struct Difference {
  std::size_t pixels = 0;
  double squares = 0;
  ChannelValues sums{};
  double largest = -1;
  std::size_t where = 0;

  void add(const Rgba& a, const Rgba& b, std::size_t index) {
    ++pixels;
    for (int c = 0; c < 3; ++c) {
      const double d = double(b[c]) - a[c];
      squares += d * d;
      sums[c] += d;
      if (std::abs(d) > largest) {
        largest = std::abs(d);
        where = index;
      }
    }
  }
};

Difference join(const Difference& left, const Difference& right) {
  Difference sum = right.largest > left.largest ? right : left;
  sum.pixels = left.pixels + right.pixels;
  sum.squares = left.squares + right.squares;
  for (int c = 0; c < 3; ++c) sum.sums[c] = left.sums[c] + right.sums[c];
  return sum;
}

/// The same to the last bit for any number of threads: the tree of sums depends on the size alone.
Difference difference(const Image& reference, const Image& test, const Mask* mask) {
  using Range = tbb::blocked_range<std::size_t>;
  return parallel_sum(
      Range(0, reference.pixels.size(), 1 << 14), Difference{},
      [&](const Range& range, Difference sum) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          if (!mask || mask->pixels[i]) sum.add(reference.pixels[i], test.pixels[i], i);
        return sum;
      },
      join);
}

std::optional<ErrorSummary> summary(const Difference& d, int width) {
  if (d.pixels == 0) return std::nullopt;
  const auto pixels = double(d.pixels);
  return ErrorSummary{d.squares / (3 * pixels),
                      {d.sums[0] / pixels, d.sums[1] / pixels, d.sums[2] / pixels},
                      {d.largest, int(d.where % width), int(d.where / width)}};
}

/// The place of the least of n sorted values that this share of them does not exceed.
std::ptrdiff_t rank(std::size_t n, double share) {
  return std::max<std::ptrdiff_t>(std::ptrdiff_t(std::ceil(share * double(n))), 1) - 1;
}

Mask within(const Mask* mask, const Mask& region) { return mask ? both(*mask, region) : region; }

}  // namespace

std::string_view name_of(Region region) {
  constexpr std::string_view names[] = {"all", "covered", "equal"};
  return names[std::size_t(region)];
}

PicturePair::PicturePair(const Image& reference, const Image& test, const PairRegions& regions)
    : reference_(reference), test_(test), regions_(regions) {
  check_size("test picture", test, reference);
  if (reference.pixels.empty()) throw InputError("reference picture: it has no pixels");
  check_finite("reference", reference);
  check_finite("test", test);
  check_regions(reference, regions);
  const CountImage *here = regions.test_layers, *there = regions.reference_layers;
  if (there) covered_ = within(regions.mask, covered_mask(*there));
  if (there && here) equal_ = within(regions.mask, equal_mask(*here, *there));
}

bool PicturePair::is_known(Region region) const {
  return region == Region::all || (region == Region::covered ? covered_ : equal_).has_value();
}

const Mask* PicturePair::mask(Region region) const {
  if (region == Region::all) return regions_.mask;
  return &*(region == Region::covered ? covered_ : equal_);
}

std::optional<double> PicturePair::covered() const {
  if (!covered_) return std::nullopt;
  const std::size_t all = is_masked() ? count(*regions_.mask) : reference_.pixels.size();
  return double(count(*covered_)) / double(all);
}

const std::optional<ErrorSummary>& PicturePair::errors(Region region) const {
  auto& known = errors_[std::size_t(region)];
  if (!known)
    known = is_known(region)
                ? summary(difference(reference_, test_, mask(region)), reference_.width)
                : std::nullopt;
  return *known;
}

std::optional<ErrorPercentiles> PicturePair::find_percentiles(Region region) const {
  std::vector<double> errors;
  errors.reserve(reference_.pixels.size());
  const Mask* mask = this->mask(region);
  for (std::size_t i = 0; i < reference_.pixels.size(); ++i)
    if (!mask || mask->pixels[i])
      errors.push_back(pixel_error(reference_.pixels[i], test_.pixels[i]));
  if (errors.empty()) return std::nullopt;
  const auto last = errors.begin() + rank(errors.size(), 0.99);
  const auto first = errors.begin() + rank(errors.size(), 0.95);
  std::nth_element(errors.begin(), last, errors.end());
  std::nth_element(errors.begin(), first, last + 1);
  return ErrorPercentiles{*first, *last};
}

const std::optional<ErrorPercentiles>& PicturePair::percentiles(Region region) const {
  auto& known = percentiles_[std::size_t(region)];
  if (!known) known = is_known(region) ? find_percentiles(region) : std::nullopt;
  return *known;
}

const SsimScores* PicturePair::ssim() const {
  if (std::min(test_.width, test_.height) < ssim_window) return nullptr;
  if (!ssim_) ssim_ = ssim_scores(reference_, test_);
  return &*ssim_;
}

const Raster<float>& PicturePair::flip() const {
  if (!flip_) flip_ = flip_map(reference_, test_);
  return *flip_;
}

std::size_t count_not_finite(const Image& image) {
  return std::size_t(std::count_if(image.pixels.begin(), image.pixels.end(),
                                   [](const Rgba& pixel) { return !finite(pixel); }));
}

void require_finite(const Image& image, std::string_view call) {
  if (const std::size_t bad = count_not_finite(image))
    throw WorkError(fmt::format("{}: {} of its picture's pixels are not finite", call, bad));
}

}  // namespace pellucid::compare
