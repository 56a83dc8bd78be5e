// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/covered_error.h"

#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "compare/pictures/ssim.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

constexpr int radius = ssim_window / 2;
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;  // Wang et al. 2004, Eq. 13, L = 1

using Weights = std::array<double, ssim_window>;

Weights gaussian_weights() {
  Weights weights{};
  double sum = 0;
  for (int k = -radius; k <= radius; ++k)
    sum += weights[k + radius] = std::exp(-0.5 * k * k / (1.5 * 1.5));
  for (double& w : weights) w /= sum;
  return weights;
}

/// Weighted moments of one channel in the window around a pixel, about the pixel's own values: the
/// variances of bright pictures keep their digits.
struct Moments {
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(double weight, double a, double b) {
    x += weight * a;
    y += weight * b;
    xx += weight * a * a;
    yy += weight * b * b;
    xy += weight * a * b;
  }
};

/// Eq. 13 of one channel at a pixel whose window lies inside.
double similarity(const Image& x, const Image& y, int column, int row, int channel) {
  static const Weights weights = gaussian_weights();
  const double x0 = x.at(column, row)[channel], y0 = y.at(column, row)[channel];
  Moments m;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i)
      m.add(weights[i + radius] * weights[j + radius], x.at(column + i, row + j)[channel] - x0,
            y.at(column + i, row + j)[channel] - y0);
  const double mean_x = x0 + m.x, mean_y = y0 + m.y;
  const double variances = m.xx - m.x * m.x + m.yy - m.y * m.y, covariance = m.xy - m.x * m.y;
  return (2 * mean_x * mean_y + c1) * (2 * covariance + c2) /
         ((mean_x * mean_x + mean_y * mean_y + c1) * (variances + c2));
}

/// Sums over the covered pixels of one row.
struct RowSums {
  double squares = 0, similarity = 0;
  std::size_t pixels = 0, windows = 0;
};

RowSums sum_row(const Image& reference, const CountImage& layers, const Image& test, int row) {
  RowSums sums;
  const bool inside = row >= radius && row < reference.height - radius;
  for (int x = 0; x < reference.width; ++x) {
    if (layers.at(x, row) == 0) continue;
    const bool window = inside && x >= radius && x < reference.width - radius;
    ++sums.pixels;
    sums.windows += window;
    for (int c = 0; c < 3; ++c) {
      const double d = double(test.at(x, row)[c]) - double(reference.at(x, row)[c]);
      sums.squares += d * d;
      if (window) sums.similarity += similarity(reference, test, x, row, c);
    }
  }
  return sums;
}

}  // namespace

CoveredError covered_error(const Image& reference, const CountImage& layers, const Image& test) {
  assert(reference.pixels.size() == test.pixels.size());
  assert(reference.pixels.size() == layers.pixels.size());
  std::vector<RowSums> rows(std::size_t(reference.height));
  parallel_for(0, reference.height,
               [&](int y) { rows[std::size_t(y)] = sum_row(reference, layers, test, y); });
  RowSums all;
  for (const RowSums& row : rows) {
    all.squares += row.squares;
    all.similarity += row.similarity;
    all.pixels += row.pixels;
    all.windows += row.windows;
  }
  CoveredError error;
  if (all.pixels > 0) error.rmse = std::sqrt(all.squares / (3.0 * double(all.pixels)));
  if (all.windows > 0) error.ssim = all.similarity / (3.0 * double(all.windows));
  return error;
}

}  // namespace pellucid::compare
