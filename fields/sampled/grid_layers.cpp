// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/grid_layers.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace pellucid::fields {
namespace {

std::vector<std::size_t> numbers_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  return numbers;
}

/// Evenly spaced positions stay so: their cells are found without a search.
Axis axis_through(std::vector<double> positions, double spacing) {
  bool is_uniform = spacing > 0;
  for (std::size_t i = 1; i < positions.size(); ++i)
    is_uniform =
        is_uniform && std::abs(positions[i] - positions[i - 1] - spacing) <= 1e-9 * spacing;
  if (is_uniform && Axis::can_be_uniform(positions.front(), spacing, positions.size()))
    return Axis::uniform(positions.front(), spacing, positions.size());
  return Axis(std::move(positions));
}

}  // namespace

GridLayers plain_layers(Axis axis, std::size_t count) {
  return {std::move(axis), numbers_to(count)};
}

GridLayers extruded_layers(double position, double width, std::size_t count, bool of_cells) {
  assert(count >= 2 && count % 2 == 0);
  std::vector<double> positions;
  for (std::size_t i = 0; i < count; ++i)
    positions.push_back(position + width * (double(i) - 0.5 * double(count - 1)));
  return {Axis(std::move(positions)),
          std::vector<std::size_t>(of_cells ? count - 1 : count, std::size_t(0))};
}

GridLayers repeated_layers(const Axis& axis, double period, bool of_cells) {
  const std::size_t count = axis.size();
  const double gap = period - (axis.back() - axis.front());
  assert(gap >= 0 && !(of_cells && gap > 0));
  std::vector<double> positions;
  for (std::size_t i = 0; i < count; ++i) positions.push_back(axis.position(i));
  GridLayers layers{axis, numbers_to(of_cells ? count - 1 : count)};
  if (gap > 0) {  // the first again
    positions.push_back(axis.front() + period);
    layers.source.push_back(0);
  }
  // One more beyond each end: of cells that are the last and the first, of points their neighbours.
  const double last_width = gap > 0 ? gap : axis.width(count - 2);
  positions.insert(positions.begin(), axis.front() - last_width);
  positions.push_back(axis.front() + period + axis.width(0));
  layers.source.insert(layers.source.begin(), gap > 0 ? count - 1 : count - 2);
  layers.source.push_back(of_cells ? 0 : 1);
  layers.axis = axis_through(std::move(positions), axis.uniform_spacing());
  return layers;
}

}  // namespace pellucid::fields
