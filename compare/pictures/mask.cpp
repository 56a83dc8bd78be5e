// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/mask.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace pellucid::compare {
namespace {

/// The mask of the pixels for which `counts` says so.
template <class T, class Counts>
Mask mask_where(const Raster<T>& raster, const Counts& counts) {
  Mask mask(raster.width, raster.height);
  std::ranges::transform(raster.pixels, mask.pixels.begin(), counts);
  return mask;
}

}  // namespace

Mask mask_of(const Image& image) {
  return mask_where(image, [](const Rgba& p) { return std::max({p.r, p.g, p.b}) >= 0.5f; });
}

Mask covered_mask(const CountImage& layers) {
  return mask_where(layers, [](std::uint32_t n) { return n > 0; });
}

Mask equal_mask(const CountImage& a, const CountImage& b) {
  assert(a.width == b.width && a.height == b.height);
  Mask mask(a.width, a.height);
  std::ranges::transform(a.pixels, b.pixels, mask.pixels.begin(), std::equal_to<>());
  return mask;
}

Mask both(const Mask& a, const Mask& b) {
  assert(a.width == b.width && a.height == b.height);
  Mask mask(a.width, a.height);
  std::ranges::transform(a.pixels, b.pixels, mask.pixels.begin(), std::logical_and<>());
  return mask;
}

std::size_t count(const Mask& mask) {
  return std::size_t(std::ranges::count(mask.pixels, std::uint8_t(1)));
}

}  // namespace pellucid::compare
