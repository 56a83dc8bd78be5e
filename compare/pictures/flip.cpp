// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "compare/pictures/flip_color.h"
#include "compare/pictures/flip_filters.h"
#include "core/machine/widest.h"
#include "core/parallel.h"
#include "scene/appearance/colormap.h"

namespace pellucid::compare {
namespace {

constexpr int ring_rows = 2 * color_radius + 1;
constexpr int band_rows = 90;  // output rows per task; 20 more are read

using Row = std::vector<float>;

/// A picture's rows as opponent colours, `color_radius` pixels longer on both sides.
struct OpponentRow {
  Row y, xy, yz;

  explicit OpponentRow(int width) : y(width + 2 * color_radius), xy(y.size()), yz(y.size()) {}
};

/// A row after the horizontal halves of all filters.
struct FilteredRow {
  Row y, xy, yz[2], smooth, edge, point;

  explicit FilteredRow(int width)
      : y(width), xy(width), yz{Row(width), Row(width)}, smooth(width), edge(width), point(width) {}
};

/// An output row of one picture: its colour and how strong edges and points are.
struct SeenRow {
  Row l, a, b, edge, point;

  explicit SeenRow(int width) : l(width), a(width), b(width), edge(width), point(width) {}
};

PELLUCID_WIDEST
void load(const Rgba* in, int width, OpponentRow& out) {
  float* y = out.y.data() + color_radius;
  float* xy = out.xy.data() + color_radius;
  float* yz = out.yz.data() + color_radius;
  const auto linear = [](float v) { return linear_of_srgb(std::min(std::max(v, 0.f), 1.f)); };
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const OpponentColor c = opponent_of_linear(linear(in[i].r), linear(in[i].g), linear(in[i].b));
    y[i] = c.y, xy[i] = c.xy, yz[i] = c.yz;
  }
}

void extend(Row& row, int width) {
  std::fill_n(row.begin(), color_radius, row[color_radius]);
  std::fill_n(row.end() - color_radius, color_radius, row[color_radius + width - 1]);
}

/// The filtered value where at(k) is the value k taps away; an odd filter takes differences.
template <int radius, int sign = 1, class At>
inline float filtered(const Taps<radius>& w, const At& at) {
  float sum = sign > 0 ? w[0] * at(0) : 0;
  for (int k = 1; k <= radius; ++k) sum += w[k] * (at(k) + sign * at(-k));
  return sum;
}

/// The same of a filter whose weights add up to 0, from the differences to the middle: 0 of what is
/// constant, where the roundings of a sum would show, since FLIP takes their root.
template <int radius, class At>
inline float filtered_differences(const Taps<radius>& w, const At& at) {
  float sum = 0;
  const float middle = at(0);
  for (int k = 1; k <= radius; ++k) sum += w[k] * ((at(k) - middle) + (at(-k) - middle));
  return sum;
}

PELLUCID_WIDEST
void filter_along(const FlipFilters& filters, const OpponentRow& in, int width, FilteredRow& out) {
  const float* y = in.y.data() + color_radius;
  const float* xy = in.xy.data() + color_radius;
  const float* yz = in.yz.data() + color_radius;
  float *oy = out.y.data(), *oxy = out.xy.data(), *o0 = out.yz[0].data(), *o1 = out.yz[1].data();
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    oy[i] = filtered<color_radius>(filters.y, [&](int k) { return y[i + k]; });
    oxy[i] = filtered<color_radius>(filters.xy, [&](int k) { return xy[i + k]; });
  }
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    o0[i] = filtered<color_radius>(filters.yz[0], [&](int k) { return yz[i + k]; });
    o1[i] = filtered<color_radius>(filters.yz[1], [&](int k) { return yz[i + k]; });
  }
  float *smooth = out.smooth.data(), *edge = out.edge.data(), *point = out.point.data();
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const auto at = [&](int k) { return y[i + k]; };
    smooth[i] = filtered<feature_radius>(filters.smooth, at);
    edge[i] = filtered<feature_radius, -1>(filters.edge, at);
    point[i] = filtered_differences<feature_radius>(filters.point, at);
  }
}

/// The rows around an output row, the nearest in place of those that the picture lacks.
using Column = std::array<const FilteredRow*, ring_rows>;

/// The same values of the rows around: at(k, i) is k rows below.
template <class Member>
struct Rows {
  std::array<const float*, ring_rows> of;

  Rows(const Column& column, const Member& member) {
    for (int k = 0; k < ring_rows; ++k) of[k] = member(*column[k]).data();
  }
  float at(int k, int i) const { return of[color_radius + k][i]; }
};

PELLUCID_WIDEST
void see_colors(const FlipFilters& filters, const Column& column, int width, SeenRow& out) {
  const Rows y(column, [](const FilteredRow& r) -> const Row& { return r.y; });
  const Rows xy(column, [](const FilteredRow& r) -> const Row& { return r.xy; });
  const Rows first(column, [](const FilteredRow& r) -> const Row& { return r.yz[0]; });
  const Rows second(column, [](const FilteredRow& r) -> const Row& { return r.yz[1]; });
  float *l = out.l.data(), *a = out.a.data(), *b = out.b.data();
#pragma GCC ivdep
  for (int i = 0; i < width; ++i)
    l[i] = filtered<color_radius>(filters.y, [&](int k) { return y.at(k, i); });
#pragma GCC ivdep
  for (int i = 0; i < width; ++i)
    a[i] = filtered<color_radius>(filters.xy, [&](int k) { return xy.at(k, i); });
#pragma GCC ivdep
  for (int i = 0; i < width; ++i)
    b[i] = filters.yz_weight[0] *
           filtered<color_radius>(filters.yz[0], [&](int k) { return first.at(k, i); });
#pragma GCC ivdep
  for (int i = 0; i < width; ++i)
    b[i] += filters.yz_weight[1] *
            filtered<color_radius>(filters.yz[1], [&](int k) { return second.at(k, i); });
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const HuntLab lab = hunt_lab_of_opponent({l[i], a[i], b[i]});
    l[i] = lab.l, a[i] = lab.a, b[i] = lab.b;
  }
}

PELLUCID_WIDEST
void see_features(const FlipFilters& filters, const Column& column, int width, SeenRow& out) {
  const Rows smooth(column, [](const FilteredRow& r) -> const Row& { return r.smooth; });
  const Rows edge(column, [](const FilteredRow& r) -> const Row& { return r.edge; });
  const Rows point(column, [](const FilteredRow& r) -> const Row& { return r.point; });
  float *edges = out.edge.data(), *points = out.point.data();
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const auto of_smooth = [&](int k) { return smooth.at(k, i); };
    const float x = filtered<feature_radius>(filters.smooth, [&](int k) { return edge.at(k, i); });
    const float y = filtered<feature_radius, -1>(filters.edge, of_smooth);
    edges[i] = std::sqrt(x * x + y * y);
  }
#pragma GCC ivdep
  for (int i = 0; i < width; ++i) {
    const auto of_smooth = [&](int k) { return smooth.at(k, i); };
    const float x = filtered<feature_radius>(filters.smooth, [&](int k) { return point.at(k, i); });
    const float y = filtered_differences<feature_radius>(filters.point, of_smooth);
    points[i] = std::sqrt(x * x + y * y);
  }
}

/// The filtered rows of a picture around an output row, which moves down by one row at a time.
class PictureRows {
 public:
  PictureRows(const Image& image, const FlipFilters& filters, int first)
      : image_(image),
        filters_(filters),
        next_(std::max(first - color_radius, 0)),
        colors_(image.width),
        ring_(ring_rows, FilteredRow(image.width)),
        seen_(image.width) {}

  const SeenRow& see(int y) {
    for (; next_ <= std::min(y + color_radius, image_.height - 1); ++next_) take(next_);
    Column column{};
    for (int k = 0; k < ring_rows; ++k)
      column[k] = &ring_[std::clamp(y + k - color_radius, 0, image_.height - 1) % ring_rows];
    see_colors(filters_, column, image_.width, seen_);
    see_features(filters_, column, image_.width, seen_);
    return seen_;
  }

 private:
  void take(int y) {
    load(&image_.at(0, y), image_.width, colors_);
    for (Row* row : {&colors_.y, &colors_.xy, &colors_.yz}) extend(*row, image_.width);
    filter_along(filters_, colors_, image_.width, ring_[y % ring_rows]);
  }

  const Image& image_;
  const FlipFilters& filters_;
  int next_;
  OpponentRow colors_;
  std::vector<FilteredRow> ring_;
  SeenRow seen_;
};

/// The exponent and the two lines that map HyAB to [0, 1]; the largest is that of green and blue.
class ColorError {
 public:
  float of(float distance) const {
    const float power = std::pow(distance, exponent);
    if (power < knee_) return knee_error / knee_ * power;
    return std::min(knee_error + (power - knee_) / (largest_ - knee_) * (1 - knee_error), 1.f);
  }

 private:
  static constexpr float exponent = 0.7f, knee_share = 0.4f, knee_error = 0.95f;
  float largest_ =
      std::pow(hyab(hunt_lab_of_linear(0, 1, 0), hunt_lab_of_linear(0, 0, 1)), exponent);
  float knee_ = knee_share * largest_;
};

void combine(const ColorError& color_error, const SeenRow& p, const SeenRow& q, int width,
             float* out) {
  for (int i = 0; i < width; ++i) {
    const float distance = hyab({p.l[i], p.a[i], p.b[i]}, {q.l[i], q.a[i], q.b[i]});
    const float feature =
        std::max(std::abs(p.edge[i] - q.edge[i]), std::abs(p.point[i] - q.point[i]));
    const float feature_error = std::sqrt(feature / std::numbers::sqrt2_v<float>);
    out[i] = distance > 0 ? std::pow(color_error.of(distance), 1 - feature_error) : 0;
  }
}

}  // namespace

Raster<float> flip_map(const Image& reference, const Image& test) {
  assert(reference.width == test.width && reference.height == test.height);
  const FlipFilters filters = make_flip_filters();
  const ColorError color_error;
  Raster<float> map(test.width, test.height);
  parallel_for(0, (test.height + band_rows - 1) / band_rows, [&](int band) {
    const int first = band * band_rows;
    PictureRows p(reference, filters, first), q(test, filters, first);
    for (int y = first; y < std::min(first + band_rows, test.height); ++y)
      combine(color_error, p.see(y), q.see(y), test.width, &map.at(0, y));
  });
  return map;
}

Image flip_picture(const Raster<float>& map) {
  static const scene::ColormapRow& colors = scene::find_colormap("magma");
  Image picture(map.width, map.height);
  std::ranges::transform(map.pixels, picture.pixels.begin(),
                         [](float error) { return Rgba(glm::vec3(colors(error)), 1.f); });
  return picture;
}

PictureForm form_of_flip() {
  PictureForm form = form_of_map("FLIP's error of each pixel, 0 to 1");
  form.png_values += ", as colours";
  return form;
}

}  // namespace pellucid::compare
