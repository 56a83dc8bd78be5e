// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/raster.h"

namespace pellucid::compare {

/// A Mask says of each pixel whether it counts: 1, or 0.
using Mask = Raster<std::uint8_t>;

/// Returns the mask of the pixels of which red, green or blue is at least a half: white counts,
/// black does not.
Mask mask_of(const Image& image);

/// Returns the mask of the pixels that have a layer.
Mask covered_mask(const CountImage& layers);

/// Returns the mask of the pixels with the same number of layers in both, which have one size.
Mask equal_mask(const CountImage& a, const CountImage& b);

/// Returns the pixels that both masks, of one size, have.
Mask both(const Mask& a, const Mask& b);

/// Returns how many pixels count.
std::size_t count(const Mask& mask);

/// Returns the mean of a map over the pixels that count, all of them if there is no mask. The map
/// lacks `margin` pixels on each side of the picture, which then don't count. Nothing where no
/// pixel does.
template <class T>
std::optional<double> mean_over(const Raster<T>& map, const Mask* mask, int margin = 0) {
  double sum = 0;
  std::size_t pixels = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (!mask || mask->at(x + margin, y + margin)) {
        sum += map.at(x, y);
        ++pixels;
      }
  return pixels > 0 ? std::optional(sum / double(pixels)) : std::nullopt;
}

}  // namespace pellucid::compare
