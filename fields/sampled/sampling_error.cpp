// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/sampling_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace pellucid::fields {
namespace {

template <class Sample>
class AxisError {
 public:
  AxisError(const DenseGrid<Sample>& grid, int axis) : grid_(grid), axis_(axis) {
    for (int a = 0; a < axis; ++a) stride_ *= grid.axes[a].size();
  }

  /// Of the cell that begins at sample `index`, number i along the axis.
  double of_lines(std::size_t index, std::size_t i) const {
    return scaled_derivative(index, i, 2) / 8;
  }
  double of_cubics(std::size_t index, std::size_t i) const {
    const bool at_end = i == 0 || i + 2 >= grid_.axes[axis_].size();
    return scaled_derivative(index, i, 3) * std::sqrt(3.0) / (at_end ? 27 : 108) +
           scaled_derivative(index, i, 4) / 384;
  }

 private:
  /// (widest gap)^order times the order-th derivative, from the order + 1 samples nearest to the
  /// cell. 0 where the axis has fewer.
  double scaled_derivative(std::size_t index, std::size_t i, std::size_t order) const {
    const std::size_t size = grid_.axes[axis_].size();
    if (order >= size) return 0;
    const std::size_t before = std::min<std::size_t>(i, (order - 1) / 2);
    const std::size_t first = std::min(i - before, size - 1 - order);
    const Sample* line = &grid_.samples[index - i * stride_];
    std::array<Vec3, 5> table{};
    for (std::size_t k = 0; k <= order; ++k) table[k] = Vec3(line[(first + k) * stride_]);
    const double gap = divide(table, first, order);
    double error = glm::length(table[0]);
    for (std::size_t k = 0; k < order; ++k) error *= gap;
    return std::isfinite(error) ? error : 0;
  }

  /// Leaves the derivative in table[0] (divided difference times order!); returns the widest gap.
  double divide(std::array<Vec3, 5>& table, std::size_t first, std::size_t order) const {
    const Axis& axis = grid_.axes[axis_];
    double widest = 0;
    for (std::size_t level = 1; level <= order; ++level)
      for (std::size_t k = 0; k + level <= order; ++k) {
        const double span = axis.position(first + k + level) - axis.position(first + k);
        table[k] = (table[k + 1] - table[k]) * (double(level) / span);
        if (level == 1) widest = std::max(widest, span);
      }
    return widest;
  }

  const DenseGrid<Sample>& grid_;
  int axis_;
  std::size_t stride_ = 1;
};

/// The largest of `error_at(index, i, j, k)` over all places of a lattice whose first axis runs
/// fastest, or 0; layers on all threads.
template <class ErrorAt>
double largest_of(std::size_t nx, std::size_t ny, std::size_t nz, const ErrorAt& error_at) {
  std::vector<double> of_layers(nz);
  parallel_for(std::size_t(0), nz, [&](std::size_t k) {
    double largest = 0;
    std::size_t index = k * nx * ny;
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i, ++index)
        largest = std::max(largest, error_at(index, i, j, k));
    of_layers[k] = largest;
  });
  return of_layers.empty() ? 0 : *std::ranges::max_element(of_layers);
}

/// |difference| / 2 from a cell to the next along each axis, summed; the largest of all cells.
template <class Sample>
double error_of_steps(const DenseGrid<Sample>& grid) {
  const std::size_t nx = grid.axes[0].size() - 1, ny = grid.axes[1].size() - 1,
                    nz = grid.axes[2].size() - 1;
  const auto step = [&](std::size_t index, std::size_t i, std::size_t count, std::size_t stride) {
    if (i + 1 >= count) return 0.0;
    const double half = glm::length(Vec3(grid.samples[index + stride] - grid.samples[index])) / 2;
    return std::isfinite(half) ? half : 0;
  };
  return largest_of(
      nx, ny, nz, [&](std::size_t index, std::size_t i, std::size_t j, std::size_t k) {
        return step(index, i, nx, 1) + step(index, j, ny, nx) + step(index, k, nz, nx * ny);
      });
}

}  // namespace

template <class Sample>
double estimate_sampling_error(const DenseGrid<Sample>& grid, int support) {
  if (support == 1) return error_of_steps(grid);
  const AxisError<Sample> axes[3] = {{grid, 0}, {grid, 1}, {grid, 2}};
  const auto error = [&](int axis, std::size_t index, std::size_t i) {
    return support == 2 ? axes[axis].of_lines(index, i) : axes[axis].of_cubics(index, i);
  };
  return largest_of(grid.axes[0].size(), grid.axes[1].size(), grid.axes[2].size(),
                    [&](std::size_t index, std::size_t i, std::size_t j, std::size_t k) {
                      return error(0, index, i) + error(1, index, j) + error(2, index, k);
                    });
}

template double estimate_sampling_error(const DenseGrid<glm::vec3>&, int);
template double estimate_sampling_error(const DenseGrid<Vec3>&, int);

}  // namespace pellucid::fields
