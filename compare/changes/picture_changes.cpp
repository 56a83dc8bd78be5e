// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/picture_changes.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "compare/cells/cell.h"
#include "compare/pictures/image_file.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// Bits, since NaN is no number's equal and 0 is -0's.
bool same_bits(const Rgba& a, const Rgba& b) {
  for (int c = 0; c < 4; ++c)
    if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
  return true;
}

/// NaN against a number is as far as can be.
double largest_difference(const Rgba& a, const Rgba& b) {
  double largest = 0;
  for (int c = 0; c < 4; ++c) {
    const double d = std::abs(double(a[c]) - double(b[c]));
    if (std::isnan(d) && std::isnan(a[c]) == std::isnan(b[c])) continue;
    largest = std::max(largest, std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
  }
  return largest;
}

std::optional<PictureChange> compare_views(const CellFiles& before, const CellFiles& after) {
  for (const CellFiles* files : {&before, &after})
    if (!fs::exists(files->picture()))
      return PictureChange{.why_not = fmt::format("{} is missing", files->picture().string())};
  const Image a = read_image(before.picture()), b = read_image(after.picture());
  if (a.width != b.width || a.height != b.height)
    return PictureChange{
        .why_not = fmt::format("{}×{} pixels, then {}×{}", a.width, a.height, b.width, b.height)};
  return picture_change(a, b);
}

/// A file that is no picture any more tells of its cell alone.
std::optional<PictureChange> change_from_view(const CellFiles& before, const CellFiles& after) {
  try {
    return compare_views(before, after);
  } catch (const InputError& error) {
    return PictureChange{.why_not = error.what()};
  }
}

}  // namespace

std::optional<PictureChange> picture_change(const Image& before, const Image& after) {
  PictureChange change;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    if (same_bits(before.pixels[i], after.pixels[i])) continue;
    if (change.pixels++ == 0) {
      change.x = int(i % std::size_t(before.width));
      change.y = int(i / std::size_t(before.width));
    }
    change.largest =
        std::max(change.largest, largest_difference(before.pixels[i], after.pixels[i]));
  }
  return change.pixels > 0 ? std::optional(change) : std::nullopt;
}

std::vector<PictureChange> picture_changes(const PastRun& before, const PastRun& after,
                                           const ResultRow& of_before, const ResultRow& of_after) {
  const auto views = std::size_t(views_of({&of_before, 1}));
  std::vector<PictureChange> changes;
  for (std::size_t view = 0; view < views; ++view) {
    std::optional<PictureChange> change =
        change_from_view(CellFiles(before.folder, of_before).from(view),
                         CellFiles(after.folder, of_after).from(view));
    if (!change) continue;
    change->view = view;
    changes.push_back(std::move(*change));
  }
  return changes;
}

}  // namespace pellucid::compare
