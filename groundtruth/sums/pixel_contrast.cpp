// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/pixel_contrast.h"

#include <algorithm>
#include <cmath>

namespace pellucid::groundtruth {
namespace {

double largest_difference(const Rgba& a, const Rgba& b) {
  double largest = 0;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, double(std::abs(a[c] - b[c])));
  return largest;
}

bool differs_from_a_neighbour(const Image& image, int x, int y, double contrast) {
  const Rgba& pixel = image.at(x, y);
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u)
      if (largest_difference(image.at(u, v), pixel) > contrast) return true;
  return false;
}

}  // namespace

std::vector<std::size_t> mark_contrasts(const Image& image, double contrast,
                                        std::vector<bool>& marked) {
  std::vector<std::size_t> found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t index = std::size_t(y) * image.width + x;
      if (marked[index] || !differs_from_a_neighbour(image, x, y, contrast)) continue;
      marked[index] = true;
      found.push_back(index);
    }
  return found;
}

}  // namespace pellucid::groundtruth
