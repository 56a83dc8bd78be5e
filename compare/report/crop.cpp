// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/crop.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace pellucid::compare {
namespace {

/// sums.at(x, y): the sum over all pixels above and left of (x, y).
Raster<double> summed_area(const Raster<double>& values) {
  Raster<double> sums(values.width + 1, values.height + 1);
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x)
      sums.at(x + 1, y + 1) =
          values.at(x, y) + sums.at(x, y + 1) + sums.at(x + 1, y) - sums.at(x, y);
  return sums;
}

}  // namespace

std::optional<Crop> fit_crop(const Crop& crop, int width, int height) {
  if (crop.x >= width || crop.y >= height) return std::nullopt;
  return Crop{crop.x, crop.y, std::min(crop.width, width - crop.x),
              std::min(crop.height, height - crop.y)};
}

void require_inside(const Crop& to, int width, int height) {
  const bool inside = to.x >= 0 && to.y >= 0 && to.width >= 1 && to.height >= 1 &&
                      to.width <= width - to.x && to.height <= height - to.y;
  if (!inside)
    throw InputError(
        fmt::format("--crop {},{},{},{}: not within the picture; accepted: X,Y,WIDTH,HEIGHT within "
                    "{}×{} pixels",
                    to.x, to.y, to.width, to.height, width, height));
}

Crop worst_crop(const Raster<double>& error) {
  const Raster<double> sums = summed_area(error);
  Crop best{0, 0, std::max(error.width / 4, 1), std::max(error.height / 4, 1)};
  double largest = -1;
  for (int y = 0; y + best.height <= error.height; ++y)
    for (int x = 0; x + best.width <= error.width; ++x) {
      const int right = x + best.width, bottom = y + best.height;
      const double sum =
          sums.at(right, bottom) - sums.at(x, bottom) - sums.at(right, y) + sums.at(x, y);
      if (sum <= largest) continue;
      largest = sum;
      best.x = x;
      best.y = y;
    }
  return best;
}

}  // namespace pellucid::compare
