// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_error.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

#include "core/indexed_random.h"
#include "core/parallel.h"

namespace pellucid::fields {
namespace {

/// The nodes that are looked at, each by its place among them.
struct Nodes {
  static constexpr std::int32_t none = -1;
  std::vector<std::int32_t> place;  // of each node of the grid
  std::size_t count = 0;
};

/// One of equally long parts of the nodes' numbers gives one each, so that none is drawn twice.
Nodes drawn_nodes(vtkIdType all, vtkIdType most) {
  Nodes nodes{std::vector<std::int32_t>(std::size_t(all), Nodes::none), 0};
  const vtkIdType count = std::min(all, most);
  for (vtkIdType i = 0; i < count; ++i) {
    const vtkIdType first = i * all / count, end = (i + 1) * all / count;
    const auto drawn = IndexedRandom(0, std::uint64_t(i)).below(0, std::uint64_t(end - first));
    nodes.place[std::size_t(first) + std::size_t(drawn)] = std::int32_t(nodes.count++);
  }
  return nodes;
}

/// A corner of a cell at a node that is looked at.
struct Corner {
  vtkIdType cell;
  int number;  // in the cell
  std::int32_t node;
};

/// In the order of the cells: sums over them are the same on any number of threads.
std::vector<Corner> corners_at(const Nodes& nodes, vtkDataSet& cells) {
  using Part = tbb::blocked_range<vtkIdType>;
  using Corners = std::vector<Corner>;
  return parallel_sum(
      Part(0, cells.GetNumberOfCells(), 1 << 14), Corners(),
      [&](const Part& part, Corners corners) {
        vtkNew<vtkIdList> points;
        for (vtkIdType i = part.begin(); i < part.end(); ++i) {
          cells.GetCellPoints(i, points);
          for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
            if (const auto node = nodes.place[std::size_t(points->GetId(k))]; node != Nodes::none)
              corners.push_back({i, int(k), node});
        }
        return corners;
      },
      [](Corners left, const Corners& right) {
        left.insert(left.end(), right.begin(), right.end());
        return left;
      });
}

/// Calls visit(number, corner, cell) for all corners, in parallel; those of a cell lie together.
template <class Visit>
void for_each_cell_at(const std::vector<Corner>& corners, vtkDataSet& cells, const Visit& visit) {
  using Part = tbb::blocked_range<std::size_t>;
  parallel_ranges(Part(0, corners.size(), 1024), [&](const Part& part) {
    vtkNew<vtkGenericCell> cell;
    vtkIdType known = -1;
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      if (corners[i].cell != known) cells.GetCell(known = corners[i].cell, cell);
      visit(i, corners[i], *cell);
    }
  });
}

/// The mean of the corners' values at each node.
template <class Value>
std::vector<Value> means_at(const std::vector<Corner>& corners, const std::vector<Value>& values,
                            std::size_t node_count) {
  std::vector<Value> sums(node_count, Value(0));
  std::vector<int> counts(node_count, 0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sums[std::size_t(corners[i].node)] += values[i];
    ++counts[std::size_t(corners[i].node)];
  }
  for (std::size_t i = 0; i < node_count; ++i) sums[i] /= double(std::max(counts[i], 1));
  return sums;
}

Vec3 center_of(const CellGrid& grid, vtkGenericCell& cell) {
  Vec3 sum(0);
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i) sum += grid.point(cell.GetPointId(i));
  return sum / double(cell.GetNumberOfPoints());
}

/// The largest length of part(i) that is finite.
template <class Part>
double largest_of(std::size_t count, const Part& part) {
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (const double length = glm::length(part(i)); std::isfinite(length))
      largest = std::max(largest, length);
  return largest;
}

double error_of_constant_cells(const CellGrid& grid, const std::vector<Corner>& corners,
                               std::size_t node_count) {
  std::vector<Vec3> velocities;
  velocities.reserve(corners.size());
  for (const Corner& corner : corners) velocities.push_back(grid.velocity(corner.cell));
  const std::vector<Vec3> means = means_at(corners, velocities, node_count);
  return largest_of(corners.size(), [&](std::size_t i) {
    return velocities[i] - means[std::size_t(corners[i].node)];
  });
}

double error_of_linear_cells(const CellGrid& grid, const std::vector<Corner>& corners,
                             std::size_t node_count) {
  std::vector<Mat3> jacobians(corners.size());
  std::vector<Vec3> arms(corners.size());
  for_each_cell_at(corners, *grid.cells,
                   [&](std::size_t i, const Corner& corner, vtkGenericCell& cell) {
                     const double* places = cell.GetParametricCoords();
                     jacobians[i] = grid.jacobian(cell, places + 3 * corner.number);
                     arms[i] = grid.point(cell.GetPointId(corner.number)) - center_of(grid, cell);
                   });
  const std::vector<Mat3> means = means_at(corners, jacobians, node_count);
  return largest_of(corners.size(), [&](std::size_t i) {
    return 0.5 * ((means[std::size_t(corners[i].node)] - jacobians[i]) * arms[i]);
  });
}

}  // namespace

double cell_sampling_error(const CellGrid& grid, vtkIdType most_nodes) {
  const Nodes nodes = drawn_nodes(grid.cells->GetNumberOfPoints(), most_nodes);
  const std::vector<Corner> corners = corners_at(nodes, *grid.cells);
  return grid.constant ? error_of_constant_cells(grid, corners, nodes.count)
                       : error_of_linear_cells(grid, corners, nodes.count);
}

}  // namespace pellucid::fields
