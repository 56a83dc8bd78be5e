// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/other_ssim.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "compare/pictures/image_file.h"
#include "compare/pictures/ssim.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

constexpr double taps = box_ssim_window * box_ssim_window;

/// SSIM of one channel in the window whose first pixel is (left, top). Variances are of differences
/// from the window's means, so that nothing cancels.
double window_ssim(const Image& x, const Image& y, int left, int top, int channel) {
  const auto sum = [&](const auto& value) {
    double total = 0;
    for (int row = top; row < top + box_ssim_window; ++row)
      for (int column = left; column < left + box_ssim_window; ++column)
        total += value(double(x.at(column, row)[channel]), double(y.at(column, row)[channel]));
    return total;
  };
  const double ux = sum([](double a, double) { return a; }) / taps;
  const double uy = sum([](double, double b) { return b; }) / taps;
  const double variances =
      sum([&](double a, double b) { return (a - ux) * (a - ux) + (b - uy) * (b - uy); }) /
      (taps - 1);
  const double covariance =
      sum([&](double a, double b) { return (a - ux) * (b - uy); }) / (taps - 1);
  return (2 * ux * uy + ssim_c1) * (2 * covariance + ssim_c2) /
         ((ux * ux + uy * uy + ssim_c1) * (variances + ssim_c2));
}

}  // namespace

double box_ssim(const Image& x, const Image& y) {
  assert(x.width == y.width && x.height == y.height);
  assert(std::min(x.width, x.height) >= box_ssim_window);
  const int columns = x.width - box_ssim_window + 1, rows = x.height - box_ssim_window + 1;
  std::vector<double> sums(rows);
  parallel_for(0, rows, [&](int top) {
    for (int left = 0; left < columns; ++left)
      for (int channel = 0; channel < 3; ++channel)
        sums[top] += window_ssim(x, y, left, top, channel);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (3.0 * columns * rows);
}

Image luma8(const Image& image) {
  Image luma(image.width, image.height);
  std::ranges::transform(image.pixels, luma.pixels.begin(), [](const Rgba& p) {
    const double y =
        0.299 * displayed_byte(p.r) + 0.587 * displayed_byte(p.g) + 0.114 * displayed_byte(p.b);
    return Rgba(glm::vec3(float(std::floor(y + 0.5) / 255)), 1.f);
  });
  return luma;
}

}  // namespace pellucid::compare
