// SPDX-License-Identifier: GPL-3.0-or-later
// That a place's bin lists every cell whose box holds it needs no tolerance: a coordinate's bin is
// a function that never falls, so that what lies between two coordinates is in the bins between
// theirs, whatever is rounded.

#include "fields/sampled/cell_locator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace pellucid::fields {
namespace {

constexpr std::uint32_t many = 64;  // cells of a bin that is divided
constexpr int deepest = 12;
constexpr double bins_per_cell = 1;
/// Of a grid, lists of bins may be so many times as long as the cells are many: large cells among
/// small ones would be in nearly all.
constexpr double longest_lists = 16, longest_of_tree = 3 * longest_lists;
constexpr double most_bins_along = 1 << 10;

}  // namespace

/// Builds a grid over a box for some of the cells, and those within it.
class CellLocator::Builder {
 public:
  using BoxOf = std::function<Box3(std::size_t)>;

  /// Cells 0 to count - 1.
  Builder(const BoxOf& box_of, std::size_t count) : box_of_(box_of), count_(count) {}
  /// Some cells, whose numbers ascend.
  Builder(const BoxOf& box_of, Cells numbers, int depth)
      : box_of_(box_of), count_(numbers.size()), numbers_(std::move(numbers)), depth_(depth) {}

  Tree build(const Box3& box) {
    box_ = box;
    grid_ = grid_over(box);
    if (depth_ > 0 && !shortens(lists_of(grid_), grid_.bins(), count_)) return {};
    count_lists();
    fill_lists();
    tree_.grids.push_back(grid_);
    if (depth_ < deepest) divide_long_lists();
    return std::move(tree_);
  }

 private:
  /// Whether lists of so many cells in all are a quarter of the list of all cells on average.
  static bool shortens(double lists, double bins, std::size_t cells) {
    return lists <= bins * double(cells) / 4;
  }

  std::uint32_t number(std::size_t i) const {
    return numbers_.empty() ? std::uint32_t(i) : numbers_[i];
  }
  Box3 cell_box(std::size_t i) const { return box_of_(number(i)); }

  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    if (depth_ > 0)  // one of many grids, which have the threads
      for (std::size_t i = 0; i < count_; ++i) visit(i);
    else
      parallel_for(std::size_t(0), count_, visit);
  }
  template <class Visit>
  void for_each_bin(const Box3& box, const Visit& visit) const {
    const Index low = grid_.at(box.min), high = grid_.at(box.max);
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i) visit(grid_.bin({i, j, k}));
  }

  /// As many bins as are asked for, or fewer, until the lists are short enough.
  Grid grid_over(const Box3& box) const {
    for (double bins = bins_per_cell * double(count_);; bins /= 2) {
      const Grid grid = grid_of(box, bins);
      if (grid.bins() == 1 || lists_of(grid) <= longest_lists * double(count_)) return grid;
    }
  }
  /// Bins that are nearly cubes; along an axis that is thinner than a bin there is one.
  static Grid grid_of(const Box3& box, double bins) {
    const Vec3 size = box.max - box.min;
    double width = 0;
    for (int round = 0; round < 3; ++round) {
      double volume = 1, axes = 0;
      for (int axis = 0; axis < 3; ++axis)
        if (size[axis] > width) volume *= size[axis], ++axes;
      if (axes > 0) width = std::pow(volume / std::max(bins, 1.0), 1 / axes);
    }
    Grid grid{box.min, Vec3(0), {1, 1, 1}, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (!(size[axis] > width)) continue;
      const double along = std::clamp(std::floor(size[axis] / width), 1.0, most_bins_along);
      grid.size[std::size_t(axis)] = int(along);
      grid.bins_per_unit[axis] = along / size[axis];
    }
    return grid;
  }
  /// About so long are the lists of all bins together: by some of the cells where they are many.
  double lists_of(const Grid& grid) const {
    constexpr std::size_t enough = 1 << 16;
    const std::size_t every = std::max<std::size_t>(count_ / enough, 1);
    double sum = 0, looked_at = 0;
    for (std::size_t i = 0; i < count_; i += every, ++looked_at) {
      const Box3 box = cell_box(i);
      const Index low = grid.at(box.min), high = grid.at(box.max);
      sum += double(high[0] - low[0] + 1) * double(high[1] - low[1] + 1) *
             double(high[2] - low[2] + 1);
    }
    return sum / looked_at * double(count_);
  }

  void count_lists() {
    tree_.bins.resize(grid_.bins());
    for_each_cell([&](std::size_t i) {
      for_each_bin(cell_box(i), [&](std::uint32_t bin) {
        std::atomic_ref(tree_.bins[bin].count).fetch_add(1, std::memory_order_relaxed);
      });
    });
    std::uint32_t first = 0;
    for (Bin& bin : tree_.bins) {
      bin.first = first;
      first += std::exchange(bin.count, 0);
    }
    tree_.lists.resize(first);
  }

  void fill_lists() {
    for_each_cell([&](std::size_t i) {
      for_each_bin(cell_box(i), [&](std::uint32_t number_of_bin) {
        Bin& bin = tree_.bins[number_of_bin];
        const auto place = std::atomic_ref(bin.count).fetch_add(1, std::memory_order_relaxed);
        tree_.lists[bin.first + place] = number(i);
      });
    });
    if (depth_ > 0) return;  // they ascend
    parallel_for(std::size_t(0), tree_.bins.size(), [&](std::size_t i) {
      const auto begin = tree_.lists.begin() + tree_.bins[i].first;
      std::sort(begin, begin + tree_.bins[i].count);
    });
  }

  void divide_long_lists() {
    std::vector<std::uint32_t> long_ones;
    for (std::uint32_t i = 0; i < tree_.bins.size(); ++i)
      if (tree_.bins[i].count > many && tree_.bins.size() > 1) long_ones.push_back(i);
    std::vector<Tree> parts(long_ones.size());
    const auto divide = [&](std::size_t i) { parts[i] = divided(long_ones[i]); };
    if (depth_ > 0)
      for (std::size_t i = 0; i < parts.size(); ++i) divide(i);
    else
      parallel_for(std::size_t(0), parts.size(), divide);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!parts[i].grids.empty()) add(long_ones[i], std::move(parts[i]));
  }

  /// The grid of a bin's own; an empty tree where it would not shorten its list.
  Tree divided(std::uint32_t number_of_bin) const {
    const Bin& bin = tree_.bins[number_of_bin];
    const auto begin = tree_.lists.begin() + bin.first;
    Tree tree = Builder(box_of_, Cells(begin, begin + bin.count), depth_ + 1)
                    .build(box_of_bin(number_of_bin));
    return double(tree.lists.size()) <= longest_of_tree * bin.count ? std::move(tree) : Tree();
  }
  /// Its cells may reach beyond: a grid takes what lies outside for what is on its border.
  Box3 box_of_bin(std::uint32_t number_of_bin) const {
    const auto nx = std::uint32_t(grid_.size[0]), ny = std::uint32_t(grid_.size[1]);
    const std::uint32_t at[3] = {number_of_bin % nx, number_of_bin / nx % ny,
                                 number_of_bin / (nx * ny)};
    Box3 box = box_;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(grid_.bins_per_unit[axis] > 0)) continue;
      box.min[axis] = grid_.low[axis] + double(at[axis]) / grid_.bins_per_unit[axis];
      box.max[axis] = grid_.low[axis] + double(at[axis] + 1) / grid_.bins_per_unit[axis];
    }
    return box;
  }

  void add(std::uint32_t number_of_bin, Tree part) {
    const auto grids = std::uint32_t(tree_.grids.size()), bins = std::uint32_t(tree_.bins.size()),
               lists = std::uint32_t(tree_.lists.size());
    tree_.bins[number_of_bin] = {grids, Bin::is_grid};
    for (Grid& grid : part.grids) grid.first += bins;
    for (Bin& bin : part.bins) bin.first += bin.count == Bin::is_grid ? grids : lists;
    tree_.grids.insert(tree_.grids.end(), part.grids.begin(), part.grids.end());
    tree_.bins.insert(tree_.bins.end(), part.bins.begin(), part.bins.end());
    tree_.lists.insert(tree_.lists.end(), part.lists.begin(), part.lists.end());
  }

  const BoxOf& box_of_;
  std::size_t count_;
  Cells numbers_;  // empty: 0, 1, …
  int depth_ = 0;
  Box3 box_;
  Grid grid_;
  Tree tree_;
};

CellLocator::CellLocator(std::size_t cells, const std::function<Box3(std::size_t)>& box_of)
    : box_(parallel_sum(
          tbb::blocked_range<std::size_t>(0, cells, 1 << 14), Box3(),
          [&](const tbb::blocked_range<std::size_t>& part, Box3 box) {
            for (std::size_t i = part.begin(); i < part.end(); ++i) {
              const Box3 cell = box_of(i);
              box.extend(cell.min);
              box.extend(cell.max);
            }
            return box;
          },
          [](Box3 a, const Box3& b) {
            a.extend(b.min);
            a.extend(b.max);
            return a;
          })),
      tree_(Builder(box_of, cells).build(box_)) {}

std::span<const std::uint32_t> CellLocator::cells_at(const Vec3& x) const {
  if (!box_.contains(x)) return {};
  const Grid* grid = &tree_.grids.front();
  for (;;) {
    const Bin& bin = tree_.bins[grid->bin(grid->at(x))];
    if (bin.count != Bin::is_grid) return {&tree_.lists[bin.first], bin.count};
    grid = &tree_.grids[bin.first];
  }
}

}  // namespace pellucid::fields
