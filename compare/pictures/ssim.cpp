// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/ssim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/machine/widest.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

constexpr int radius = ssim_window / 2;
constexpr int channels = int(std::tuple_size_v<ChannelValues>);
constexpr int margin = radius * channels;  // values of a row whose window sticks out on one side
constexpr int band_rows = 32;              // output rows per task; 10 more are read

/// w[k] weighs the taps at -k and +k; all eleven add to 1.
using Taps = std::array<double, radius + 1>;

Taps gaussian_taps() {
  Taps w{};
  double sum = 0;
  for (int k = 0; k <= radius; ++k) {
    w[k] = std::exp(-0.5 * k * k / (1.5 * 1.5));
    sum += k == 0 ? w[k] : 2 * w[k];
  }
  for (double& tap : w) tap /= sum;
  return w;
}

/// Variances don't change when a constant is subtracted. The mean of a channel takes away the
/// cancellation in E[x²] - E[x]² of bright pictures.
using Means = ChannelValues;

Means channel_means(const Image& image) {
  Means sum{};
  for (const Rgba& pixel : image.pixels)
    for (int c = 0; c < channels; ++c) sum[c] += pixel[c];
  for (double& s : sum) s /= double(image.pixels.size());
  return sum;
}

/// A row of one moment: red, green, blue of each pixel, one after another.
using Row = std::vector<double>;

struct MomentRows {
  Row x, y, squares, product;  // E[x], E[y], E[x² + y²], E[xy] once they are filtered

  explicit MomentRows(std::size_t n) : x(n), y(n), squares(n), product(n) {}
};

/// Pointers to the eleven rows around an output row, top to bottom.
using RowPointers = std::array<const double*, ssim_window>;

/// The last eleven rows of a picture, less its means.
class RowWindow {
 public:
  RowWindow(const Image& image, const Means& means)
      : image_(image),
        means_(means),
        rows_(ssim_window, Row(std::size_t(image.width) * channels)) {}

  void load(int y) {
    double* out = rows_[y % ssim_window].data();
    const Rgba* in = &image_.at(0, y);
    for (int x = 0; x < image_.width; ++x)
      for (int c = 0; c < channels; ++c) out[x * channels + c] = in[x][c] - means_[c];
  }

  /// The rows around the output row whose lowest tap is `last`.
  RowPointers pointers(int last) const {
    RowPointers rows{};
    for (int k = 0; k < ssim_window; ++k)
      rows[k] = rows_[(last - 2 * radius + k) % ssim_window].data();
    return rows;
  }

 private:
  const Image& image_;
  Means means_;
  std::vector<Row> rows_;
};

/// The vertical half of the window. `ivdep`: the outputs overlap nothing.
PELLUCID_WIDEST
void filter_columns(const Taps& w, const RowPointers& x, const RowPointers& y, std::size_t n,
                    MomentRows& out) {
  double *ox = out.x.data(), *oy = out.y.data();
  double *os = out.squares.data(), *op = out.product.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const double xc = x[radius][i], yc = y[radius][i];
    double mx = w[0] * xc, my = w[0] * yc;
    double ms = w[0] * (xc * xc + yc * yc), mp = w[0] * (xc * yc);
    for (int k = 1; k <= radius; ++k) {
      const double x0 = x[radius - k][i], x1 = x[radius + k][i];
      const double y0 = y[radius - k][i], y1 = y[radius + k][i];
      mx += w[k] * (x0 + x1);
      my += w[k] * (y0 + y1);
      ms += w[k] * ((x0 * x0 + y0 * y0) + (x1 * x1 + y1 * y1));
      mp += w[k] * (x0 * y0 + x1 * y1);
    }
    ox[i] = mx, oy[i] = my, os[i] = ms, op[i] = mp;
  }
}

/// The horizontal half: the filtered value around v[0].
inline double filter_row(const Taps& w, const double* v) {
  double sum = w[0] * v[0];
  for (int k = 1; k <= radius; ++k) sum += w[k] * (v[-k * channels] + v[k * channels]);
  return sum;
}

/// The scores of a row of pixels whose windows lie inside: red, green, blue of each, one after
/// another.
struct ScoreRows {
  Row similarity, contrast;

  explicit ScoreRows(std::size_t n) : similarity(n), contrast(n) {}
};

/// Eq. 13, and its second factor alone. E - (m·m + m·m) and 2(E - m·m) round alike when x = y, so
/// that both quotients are 1 exactly.
PELLUCID_WIDEST
void score(const Taps& w, const MomentRows& moments, const double* mean_x, const double* mean_y,
           std::size_t n, ScoreRows& out) {
  const double *px = moments.x.data() + margin, *py = moments.y.data() + margin;
  const double *ps = moments.squares.data() + margin, *pp = moments.product.data() + margin;
  double *similarity = out.similarity.data(), *contrast = out.contrast.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const double mx = filter_row(w, px + i), my = filter_row(w, py + i);
    const double variances = filter_row(w, ps + i) - (mx * mx + my * my);
    const double covariance = filter_row(w, pp + i) - mx * my;
    const double ux = mx + mean_x[i], uy = my + mean_y[i];
    const double luminance = (2 * (ux * uy) + ssim_c1) / (ux * ux + uy * uy + ssim_c1);
    contrast[i] = (2 * covariance + ssim_c2) / (variances + ssim_c2);
    similarity[i] = luminance * contrast[i];
  }
}

/// The pictures' means, repeated along a row.
Row repeated(const Means& means, std::size_t n) {
  Row row(n);
  for (std::size_t i = 0; i < n; ++i) row[i] = means[i % channels];
  return row;
}

struct Pair {
  const Image& x;
  const Image& y;
  Means mean_x = channel_means(x);
  Means mean_y = channel_means(y);

  int rows() const { return x.height - 2 * radius; }
  std::size_t row_values() const { return std::size_t(x.width) * channels; }
  std::size_t scores() const { return row_values() - 2 * margin; }
};

/// Sums of a row's scores by channel.
struct RowSums {
  ChannelValues similarity{}, contrast{};
};

/// Puts a row's scores into the map, as the mean of the channels, and into the sums.
void take(const ScoreRows& scores, double* map, RowSums& sums) {
  for (std::size_t i = 0; i < scores.similarity.size(); i += channels) {
    const double* s = &scores.similarity[i];
    *map++ = (s[0] + s[1] + s[2]) / channels;
    for (int c = 0; c < channels; ++c) {
      sums.similarity[c] += s[c];
      sums.contrast[c] += scores.contrast[i + c];
    }
  }
}

/// Scores the output rows [first, last).
void score_band(const Pair& pair, const Taps& taps, int first, int last, Raster<double>& map,
                std::vector<RowSums>& sums) {
  RowWindow x(pair.x, pair.mean_x), y(pair.y, pair.mean_y);
  MomentRows moments(pair.row_values());
  ScoreRows scores(pair.scores());
  const Row mean_x = repeated(pair.mean_x, pair.scores());
  const Row mean_y = repeated(pair.mean_y, pair.scores());
  for (int row = first; row < last + 2 * radius; ++row) {
    x.load(row);
    y.load(row);
    if (row < first + 2 * radius) continue;
    filter_columns(taps, x.pointers(row), y.pointers(row), pair.row_values(), moments);
    score(taps, moments, mean_x.data(), mean_y.data(), pair.scores(), scores);
    const int out = row - 2 * radius;
    take(scores, &map.at(0, out), sums[std::size_t(out)]);
  }
}

ChannelValues mean_of(const std::vector<RowSums>& rows, ChannelValues RowSums::*member,
                      double pixels) {
  ChannelValues mean{};
  for (const RowSums& row : rows)
    for (int c = 0; c < channels; ++c) mean[c] += (row.*member)[c];
  for (double& m : mean) m /= pixels;
  return mean;
}

}  // namespace

SsimScores ssim_scores(const Image& x, const Image& y) {
  assert(x.width == y.width && x.height == y.height);
  assert(std::min(x.width, x.height) >= ssim_window);
  const Pair pair{x, y};
  const Taps taps = gaussian_taps();
  SsimScores scores{Raster<double>(x.width - 2 * radius, pair.rows()), {}, {}};
  std::vector<RowSums> sums(std::size_t(pair.rows()));
  parallel_for(0, (pair.rows() + band_rows - 1) / band_rows, [&](int band) {
    const int first = band * band_rows;
    score_band(pair, taps, first, std::min(first + band_rows, pair.rows()), scores.map, sums);
  });
  const auto pixels = double(scores.map.pixels.size());
  scores.similarity = mean_of(sums, &RowSums::similarity, pixels);
  scores.contrast = mean_of(sums, &RowSums::contrast, pixels);
  return scores;
}

}  // namespace pellucid::compare
