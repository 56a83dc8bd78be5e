// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for what uses .vdb files' grids alone.

#include <malloc.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <atomic>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace pellucid::fields {

/// What becomes of a grid whose values are copied: emptied, it gives memory back as they are, so
/// that no value of many millions is there twice.
enum class GridUse { kept, emptied };

/// Copies the values of all voxels in a box, those of tiles and of the background among them:
/// layers of leaves one after another, each on all threads.
template <class Grid, class SampleOf>
class VdbValues {
 public:
  using Value = typename Grid::ValueType;
  using Leaf = typename Grid::TreeType::LeafNodeType;
  using Sample = std::decay_t<std::invoke_result_t<SampleOf, const Value&>>;

  VdbValues(Grid& grid, const openvdb::CoordBBox& box, GridUse use, SampleOf sample_of)
      : grid_(grid), box_(box), use_(use), sample_of_(std::move(sample_of)) {}

  /// x runs fastest.
  std::vector<Sample> copy() {
    const std::vector<Run> rows = runs_along(1);
    const auto row_size = std::size_t(box_.dim().x());
    const std::size_t layer_size = row_size * std::size_t(box_.dim().y());
    std::vector<Sample> samples;
    samples.reserve(layer_size * std::size_t(box_.dim().z()));
    for (const Run& layers : runs_along(2)) {
      samples.resize(samples.size() + layer_size * std::size_t(layers.last - layers.first + 1));
      const auto to = [&](int j, int k) {
        return &samples[layer_size * std::size_t(k - box_.min().z()) +
                        row_size * std::size_t(j - box_.min().y())];
      };
      parallel_for(std::size_t(0), rows.size(),
                   [&](std::size_t i) { copy_leaves(rows[i], layers, to); });
      give_back();
    }
    if (use_ == GridUse::emptied) grid_.clear();
    return samples;
  }

 private:
  /// Voxels along an axis that are one leaf's.
  struct Run {
    int first, last;
  };

  std::vector<Run> runs_along(int axis) const {
    constexpr int within_leaf = Leaf::DIM - 1;
    std::vector<Run> runs;
    for (int at = box_.min()[axis]; at <= box_.max()[axis]; at = runs.back().last + 1)
      runs.push_back({at, std::min(at | within_leaf, box_.max()[axis])});
    return runs;
  }

  template <class To>
  void copy_leaves(const Run& rows, const Run& layers, const To& to) {
    for (const Run& along : runs_along(0)) {
      const openvdb::Coord corner(along.first, rows.first, layers.first);
      Leaf* leaf = grid_.tree().probeLeaf(corner);
      const Value everywhere = leaf ? Value() : grid_.tree().getValue(corner);  // a tile's
      for (int k = layers.first; k <= layers.last; ++k)
        for (int j = rows.first; j <= rows.last; ++j) {
          Sample* row = to(j, k) + (along.first - box_.min().x());
          for (int i = along.first; i <= along.last; ++i)
            *row++ = sample_of_(leaf ? leaf->getValue({i, j, k}) : everywhere);
        }
      if (leaf && use_ == GridUse::emptied) forget(*leaf);
    }
  }

  void forget(Leaf& leaf) {
    typename Leaf::Buffer none(openvdb::PartialCreate(), grid_.background());
    leaf.swap(none);
    forgotten_ += Leaf::SIZE * sizeof(Value);
  }

  /// Freed pieces of the heap go back to the system when they are many.
  void give_back() {
    constexpr std::size_t many = 64 << 20;
    if (forgotten_ < many) return;
    ::malloc_trim(0);
    forgotten_ = 0;
  }

  Grid& grid_;
  openvdb::CoordBBox box_;
  GridUse use_;
  SampleOf sample_of_;
  std::atomic<std::size_t> forgotten_ = 0;  // bytes, not given back yet
};

/// Returns what `sample_of` makes of the values of a box's voxels; see VdbValues.
template <class Grid, class SampleOf>
auto values_in(Grid& grid, const openvdb::CoordBBox& box, GridUse use, SampleOf sample_of) {
  return VdbValues<Grid, SampleOf>(grid, box, use, std::move(sample_of)).copy();
}

}  // namespace pellucid::fields
