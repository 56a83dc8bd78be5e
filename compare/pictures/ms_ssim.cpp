// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/ms_ssim.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace pellucid::compare {
namespace {

/// β = γ of scales 1 … 5, and α of the fifth; they add to 1.
constexpr double weights[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
constexpr int scales = int(std::size(weights));

/// The picture of half the size: means of 2×2 pixels.
Image halved(const Image& image) {
  Image half((image.width + 1) / 2, (image.height + 1) / 2);
  parallel_for(0, half.height, [&](int y) {
    const int y0 = 2 * y, y1 = std::min(y0 + 1, image.height - 1);
    for (int x = 0; x < half.width; ++x) {
      const int x0 = 2 * x, x1 = std::min(x0 + 1, image.width - 1);
      const auto at = [&](int i, int j) {
        return glm::dvec4(image.at(i, j));
      };  // four may overflow
      half.at(x, y) = 0.25 * ((at(x0, y0) + at(x1, y0)) + (at(x0, y1) + at(x1, y1)));
    }
  });
  return half;
}

void multiply(ChannelValues& product, const ChannelValues& means, double weight) {
  for (std::size_t c = 0; c < product.size(); ++c)
    product[c] *= std::pow(std::max(means[c], 0.0), weight);
}

}  // namespace

double mean_ms_ssim(const Image& x, const Image& y, const SsimScores& finest) {
  assert(std::min(x.width, x.height) >= ms_ssim_side);
  ChannelValues product{1, 1, 1};
  multiply(product, finest.contrast, weights[0]);
  Image a = halved(x), b = halved(y);
  for (int scale = 1; scale < scales; ++scale) {
    const SsimScores scores = ssim_scores(a, b);
    const bool coarsest = scale == scales - 1;
    multiply(product, coarsest ? scores.similarity : scores.contrast, weights[scale]);
    if (coarsest) break;
    a = halved(a);
    b = halved(b);
  }
  return (product[0] + product[1] + product[2]) / 3;
}

}  // namespace pellucid::compare
