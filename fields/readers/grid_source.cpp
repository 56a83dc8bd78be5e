// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/grid_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "fields/finite.h"
#include "fields/sampled/grid_layers.h"
#include "fields/sampled/periodic_field.h"
#include "fields/sampled/planar_field.h"

namespace pellucid::fields {
namespace {

// Of a spacing: lengths are written in decimals.
constexpr double length_rounding = 1e-4;
// Of a spacing, where degrees are written with a few decimals: 0.08, 0.17, 0.25, … for twelfths.
constexpr double degree_rounding = 0.1;
// Of the largest coordinate: positions are kept in floats, and so is each end of a spacing.
constexpr double float_rounding = 0x1p-22;
// Of the largest sample: those at both ends of a period were computed in floats, each by itself.
constexpr double sample_rounding = 1e-6;
// Of the coordinates: a plane kept in floats, and a seed on it in decimals, are off by less.
constexpr double plane_rounding = 1e-6;

template <class Sample>
class Maker {
 public:
  explicit Maker(GridSource<Sample> source)
      : source_(std::move(source)), of_cells_(source_.interpolation == Interpolation::constant) {
    for (std::size_t a = 0; a < 3; ++a)
      size_[a] = source_.axes[a].axis ? source_.axes[a].axis->size() - of_cells_ : 1;
    find_flat_axis();
  }

  std::unique_ptr<VectorField> field() {
    const auto repeats = find_repeats();
    if (source_.averaged && (repeats[0] || repeats[1] || repeats[2])) join_ends(repeats);
    std::array<GridLayers, 3> layers{layers_along(0, repeats[0]), layers_along(1, repeats[1]),
                                     layers_along(2, repeats[2])};
    DenseGrid<Sample> grid{
        {layers[0].axis, layers[1].axis, layers[2].axis}, laid_out(layers), source_.frame};
    auto field =
        make_dense_field(std::move(grid), source_.interpolation, std::move(source_.description));
    if (repeats[0] || repeats[1] || repeats[2])
      field = make_periodic_field(std::move(field), repeats);
    if (flat_)
      field = make_planar_field(std::move(field), plane(), bounds(repeats), source_.quantity);
    return field;
  }

 private:
  using Repeats = std::array<std::optional<Repeat>, 3>;
  static constexpr std::string_view axis_names = "xyz";

  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(fmt::format("{}: {}", source_.file, why));
  }

  void find_flat_axis() {
    for (std::size_t a = 0; a < 3; ++a) {
      if (source_.axes[a].axis) continue;
      if (flat_)
        fail("it has two samples or more along fewer than two axes; accepted: two or three");
      flat_ = int(a);
    }
  }

  // Of the layers across an axis.

  const Sample& sample(std::size_t axis, std::size_t layer, std::size_t i, std::size_t j) const {
    return source_.samples[index(axis, layer, i, j)];
  }
  std::size_t index(std::size_t axis, std::size_t layer, std::size_t i, std::size_t j) const {
    std::size_t at[3];
    at[axis] = layer, at[(axis + 1) % 3] = i, at[(axis + 2) % 3] = j;
    return at[0] + size_[0] * (at[1] + size_[1] * at[2]);
  }
  template <class Visit>
  void for_each_across(std::size_t axis, const Visit& visit) const {
    for (std::size_t j = 0; j < size_[(axis + 2) % 3]; ++j)
      for (std::size_t i = 0; i < size_[(axis + 1) % 3]; ++i) visit(i, j);
  }

  /// Not-a-numbers, as on land, are equal to each other.
  bool equals_first(std::size_t axis, std::size_t layer) const {
    double largest = 0, difference = 0;
    bool same_holes = true;
    for_each_across(axis, [&](std::size_t i, std::size_t j) {
      const Vec3 a(sample(axis, 0, i, j)), b(sample(axis, layer, i, j));
      same_holes &= is_finite(a) == is_finite(b);
      if (!is_finite(a) || !is_finite(b)) return;
      largest = std::max({largest, glm::length(a), glm::length(b)});
      difference = std::max(difference, glm::length(a - b));
    });
    return same_holes && difference <= sample_rounding * largest;
  }
  bool is_constant_along(std::size_t axis) const {
    for (std::size_t layer = 1; layer < size_[axis]; ++layer)
      if (!equals_first(axis, layer)) return false;
    return true;
  }

  // Periods.

  bool has_cells() const { return of_cells_ || source_.averaged; }

  Repeats find_repeats() {
    Repeats repeats;
    for (std::size_t a = 0; a < 3; ++a)
      if (const auto& length = source_.periods.along[a])
        repeats[a] = Repeat{source_.axes[a].front(), period_along(a, *length)};
    if (!source_.periods.given && is_longitude()) {
      repeats[0] = Repeat{source_.axes[0].front(), 360};
      source_.description += ", x taken as a longitude";
    }
    return repeats;
  }

  double period_along(std::size_t a, double given) const {
    const std::string_view name = axis_names.substr(a, 1);
    if (source_.frame) fail("periodic: its axes are turned; accepted: axes along the world's");
    if (!source_.axes[a].axis) fail(fmt::format("periodic={}: it has one sample there", name));
    const Axis& axis = *source_.axes[a].axis;
    const double length = axis.back() - axis.front();
    const double slack = length_rounding * axis.smallest_width();
    const double period = given > 0 ? given : own_period(a, axis);
    if (std::abs(period - length) <= slack) return length;
    if (period < length || has_cells())
      fail(fmt::format("periodic={}:{}; accepted: {} {:.12g}, which its {} take", name, period,
                       has_cells() ? "its length" : "at least", length,
                       has_cells() ? "cells" : "samples"));
    return period;
  }

  /// Where the last layer equals the first at one time, or of one array, it may do so by chance.
  /// So a period with a spacing more holds for all, and one that another's last layer contradicts
  /// is refused.
  double own_period(std::size_t a, const Axis& axis) const {
    const double length = axis.back() - axis.front();
    if (has_cells()) return length;
    if (!source_.periods.told) return period_by_samples(a, axis);
    std::optional<double>& told = (*source_.periods.told)[a];
    if (!told) told = period_by_samples(a, axis);
    if (*told <= length && !equals_first(a, size_[a] - 1))
      fail(
          fmt::format("periodic={0}: the last layer along {0} is not the first again, as it is "
                      "where the field was read before; accepted: periodic={0}:LENGTH",
                      axis_names.substr(a, 1)));
    return *told;
  }

  double period_by_samples(std::size_t a, const Axis& axis) const {
    const double length = axis.back() - axis.front();
    const std::string_view name = axis_names.substr(a, 1);
    if (is_constant_along(a))
      fail(
          fmt::format("periodic={0}: its samples do not change along {0}, so that they do not tell "
                      "whether the last is the first again; accepted: periodic={0}:LENGTH",
                      name));
    if (equals_first(a, size_[a] - 1)) return length;
    if (!is_even(axis, length_rounding))
      fail(
          fmt::format("periodic={0}: its spacing along {0} is not even; accepted: "
                      "periodic={0}:LENGTH",
                      name));
    return length + length / double(axis.size() - 1);
  }

  /// `rounding` is a share of the spacing.
  static bool is_even(const Axis& axis, double rounding) {
    const double spacing = (axis.back() - axis.front()) / double(axis.size() - 1);
    const double slack =
        std::max(rounding * spacing,
                 float_rounding * std::max(std::abs(axis.front()), std::abs(axis.back())));
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      if (std::abs(axis.width(i) - spacing) > slack) return false;
    return true;
  }

  bool is_longitude() const {
    const auto &x = source_.axes[0], &y = source_.axes[1];
    if (source_.frame || !x.axis || !is_even(*x.axis, degree_rounding)) return false;
    // A section along one latitude; at y = 0 it may as well be a picture 360 samples wide.
    if (!y.axis && y.front() == 0) return false;
    if (y.front() < -90 || y.back() > 90) return false;
    const double length = x.back() - x.front(), spacing = length / double(x.axis->size() - 1);
    const auto is_a_turn = [&](double angle) {
      return std::abs(angle - 360) <= degree_rounding * spacing;
    };
    if (is_a_turn(length)) return has_cells() || equals_first(0, size_[0] - 1);
    return !has_cells() && is_a_turn(length + spacing);
  }

  /// The first and the last layer are one: each is the mean of the cells on its own side.
  void join_ends(const Repeats& repeats) {
    std::vector<Sample> samples(source_.samples.begin(), source_.samples.end());
    for (std::size_t a = 0; a < 3; ++a)
      if (repeats[a])
        for_each_across(a, [&](std::size_t i, std::size_t j) {
          Sample& first = samples[index(a, 0, i, j)];
          Sample& last = samples[index(a, size_[a] - 1, i, j)];
          using Number = typename Sample::value_type;
          first = last = (first + last) * Number(0.5);
        });
    source_.samples = std::move(samples);
  }

  // The dense grid.

  GridLayers layers_along(std::size_t a, const std::optional<Repeat>& repeat) const {
    const FileAxis& axis = source_.axes[a];
    if (repeat) return repeated_layers(*axis.axis, repeat->period, of_cells_);
    if (axis.axis) return plain_layers(*axis.axis, size_[a]);
    const std::size_t count = source_.interpolation == Interpolation::c1 ? 4 : 2;
    return extruded_layers(axis.only, smallest_width(), count, of_cells_);
  }

  double smallest_width() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const FileAxis& axis : source_.axes)
      if (axis.axis) smallest = std::min(smallest, axis.axis->smallest_width());
    return smallest;
  }

  SharedSamples<Sample> laid_out(const std::array<GridLayers, 3>& layers) {
    const std::size_t nx = layers[0].source.size(), ny = layers[1].source.size(),
                      nz = layers[2].source.size();
    if (nx == size_[0] && ny == size_[1] && nz == size_[2]) return std::move(source_.samples);
    std::vector<Sample> samples;
    samples.reserve(nx * ny * nz);
    for (const std::size_t k : layers[2].source)
      for (const std::size_t j : layers[1].source)
        for (const std::size_t i : layers[0].source)
          samples.push_back(source_.samples[i + size_[0] * (j + size_[1] * k)]);
    return samples;
  }

  // The plane.

  Box3 grid_box() const {
    const auto& axes = source_.axes;
    return {{axes[0].front(), axes[1].front(), axes[2].front()},
            {axes[0].back(), axes[1].back(), axes[2].back()}};
  }
  Box3 world_box() const {
    return source_.frame ? source_.frame->world_box(grid_box()) : grid_box();
  }

  Plane plane() const {
    const Box3 box = world_box();
    const Vec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    const double slack = plane_rounding * std::max(box.diagonal(), glm::length(farthest));
    Vec3 normal(0);
    normal[*flat_] = 1;
    if (!source_.frame) return {box.min, normal, slack};
    // Rows of grid_from_world are across the planes of equal grid coordinates.
    const Vec3 across = glm::transpose(source_.frame->grid_from_world)[*flat_];
    return {box.center(), glm::normalize(across), slack};
  }

  Box3 bounds(const Repeats& repeats) const {
    Box3 box = world_box();
    for (int a = 0; a < 3; ++a)
      if (repeats[std::size_t(a)]) {
        box.min[a] = -std::numeric_limits<double>::infinity();
        box.max[a] = std::numeric_limits<double>::infinity();
      }
    return box;
  }

  GridSource<Sample> source_;
  bool of_cells_;
  std::array<std::size_t, 3> size_{};  // of the file's layers of samples
  std::optional<int> flat_;
};

}  // namespace

template <class Sample>
std::unique_ptr<VectorField> make_grid_field(GridSource<Sample> source) {
  return Maker<Sample>(std::move(source)).field();
}

template std::unique_ptr<VectorField> make_grid_field(GridSource<glm::vec3>);
template std::unique_ptr<VectorField> make_grid_field(GridSource<Vec3>);

}  // namespace pellucid::fields
