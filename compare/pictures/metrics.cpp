// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/metrics.h"

#include <algorithm>

#include "compare/pictures/image_file.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

const MetricRow& row_named(std::string_view name) { return find_row("metric", name, metrics()); }

std::size_t place_of(std::string_view name) {
  return std::size_t(&row_named(name) - &metrics()[0]);
}

/// The metric of that name of two whole pictures.
std::optional<double> number(std::string_view name, const Image& reference, const Image& test) {
  const MetricRow& row = row_named(name);
  return row.measure(PicturePair(reference, test), row.region);
}

bool is_chosen(const MetricRow& row, std::span<const std::string> names) {
  if (names.empty()) return !row.on_request;
  return std::ranges::find(names, row.name) != names.end();
}

}  // namespace

const std::optional<double>& Metrics::of(std::string_view name) const {
  return values_[place_of(name)];
}

std::optional<double>& Metrics::of(std::string_view name) { return values_[place_of(name)]; }

double rmse(const Image& reference, const Image& test) { return *number("rmse", reference, test); }

double psnr(const Image& reference, const Image& test) { return *number("psnr", reference, test); }

MaxError max_error(const Image& reference, const Image& test) {
  return PicturePair(reference, test).errors(Region::all)->max;
}

std::optional<double> ssim(const Image& reference, const Image& test) {
  return number("ssim", reference, test);
}

std::optional<double> ms_ssim(const Image& reference, const Image& test) {
  return number("ms_ssim", reference, test);
}

double flip(const Image& reference, const Image& test) { return *number("flip", reference, test); }

Metrics metrics_of(const PicturePair& pair, std::span<const std::string> names) {
  for (const std::string& name : names) row_named(name);
  Metrics measured;
  for (std::size_t i = 0; i < metrics().size(); ++i)
    if (const MetricRow& row = metrics()[i]; is_chosen(row, names))
      measured[i] = row.measure(pair, row.region);
  measured.max_error_x = pair.errors(Region::all)->max.x;
  measured.max_error_y = pair.errors(Region::all)->max.y;
  measured.covered = pair.covered();
  return measured;
}

Comparison compare_pair(const PicturePair& pair, std::span<const std::string> names) {
  std::vector<std::string> displayed;
  for (const MetricRow& row : metrics())
    if (row.displayed && is_chosen(row, names)) displayed.emplace_back(row.name);
  Comparison comparison{metrics_of(pair, names), {}};
  if (displayed.empty()) return comparison;
  const Image reference = displayed_values(pair.reference()), test = displayed_values(pair.test());
  comparison.displayed = metrics_of(PicturePair(reference, test, pair.regions()), displayed);
  return comparison;
}

Comparison compare_images(const Image& reference, const Image& test, const PairRegions& regions) {
  return compare_pair(PicturePair(reference, test, regions));
}

double max_alpha_error(const Image& reference, const Image& test) {
  double largest = 0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i)
    largest = std::max(largest, std::abs(double(reference.pixels[i].a) - test.pixels[i].a));
  return largest;
}

}  // namespace pellucid::compare
