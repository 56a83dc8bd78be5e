// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/narrow_band.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"
#include "fields/files/vdb_box.h"

namespace pellucid::fields {
namespace {

/// A layer of voxels across z: their values, and whether they are active.
struct Layer {
  std::vector<double> values;
  std::vector<char> active;
};

template <class Accessor>
Layer layer_of(const Accessor& voxels, const openvdb::CoordBBox& box, int k) {
  const std::size_t count = std::size_t(box.dim().x()) * std::size_t(box.dim().y());
  Layer layer;
  layer.values.reserve(count);
  layer.active.reserve(count);
  for (int j = box.min().y(); j <= box.max().y(); ++j)
    for (int i = box.min().x(); i <= box.max().x(); ++i) {
      typename Accessor::ValueType value;
      layer.active.push_back(voxels.probeValue({i, j, k}, value));
      layer.values.push_back(double(value));
    }
  return layer;
}

/// Of the cells between two layers, whose rows have `width` voxels.
ValueGaps gaps_between(const Layer& below, const Layer& above, std::size_t width) {
  ValueGaps gaps;
  for (std::size_t at = 0; at + width + 1 < below.values.size(); ++at) {
    if (at % width == width - 1) continue;  // the row ends
    bool active = true;
    double low = below.values[at], high = low;
    for (const Layer* layer : {&below, &above})
      for (const std::size_t corner : {at, at + 1, at + width, at + width + 1}) {
        active = active && layer->active[corner];
        low = std::min(low, layer->values[corner]);
        high = std::max(high, layer->values[corner]);
      }
    if (!active) gaps.add(low, high);
  }
  return gaps;
}

template <class Grid>
void add_gaps(const Grid& grid, ValueGaps& gaps) {
  const openvdb::CoordBBox box = box_of_values(grid);
  if (box.empty()) return;
  constexpr int layers_at_once = 16;  // of which each but the outermost is looked up once
  const int cells = box.max().z() - box.min().z();
  std::vector<ValueGaps> slabs(std::size_t((cells + layers_at_once - 1) / layers_at_once));
  parallel_for(std::size_t(0), slabs.size(), [&](std::size_t slab) {
    const auto voxels = grid.getConstAccessor();
    const int first = box.min().z() + int(slab) * layers_at_once;
    Layer below = layer_of(voxels, box, first);
    for (int k = first + 1; k <= std::min(first + layers_at_once, box.max().z()); ++k) {
      Layer above = layer_of(voxels, box, k);
      slabs[slab].add(gaps_between(below, above, std::size_t(box.dim().x())));
      below = std::move(above);
    }
  });
  for (const ValueGaps& slab : slabs) gaps.add(slab);
}

}  // namespace

void add_gaps_beyond_band(const openvdb::GridBase::Ptr& grid, ValueGaps& gaps) {
  if (!grid || grid->getGridClass() != openvdb::GRID_LEVEL_SET) return;
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) add_gaps(*floats, gaps);
  if (const auto doubles = openvdb::gridPtrCast<openvdb::DoubleGrid>(grid))
    add_gaps(*doubles, gaps);
}

}  // namespace pellucid::fields
