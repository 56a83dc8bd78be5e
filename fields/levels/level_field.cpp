// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/options/names.h"
#include "fields/dual.h"
#include "fields/levels/level_blocks.h"

namespace pellucid::fields {
namespace {

std::vector<ScalarLevel> prepared(std::vector<ScalarLevel> levels, Reconstruction kind) {
  if (levels.empty()) throw InputError("no level; accepted: at least one");
  for (std::size_t i = 0; i < levels.size(); ++i)
    check_level(fmt::format("level {}", i), levels[i]);
  levels = joined_blocks(std::move(levels));
  if (kind != Reconstruction::hat) add_seams(levels);  // hats of blocks overlap by themselves
  std::stable_sort(levels.begin(), levels.end(),
                   [](const auto& a, const auto& b) { return a.width < b.width; });
  return levels;
}

Box3 shrink(const Box3& box, double by) { return {box.min + by, box.max - by}; }

/// Where a level has weight, and where it is alone: a coarse cell's hat reaches its width into the
/// cells of a finer level; a fading level is alone from its second layer of samples on.
std::vector<LevelRegion> regions_of(std::span<const ScalarLevel> levels, Reconstruction kind) {
  std::vector<LevelRegion> regions;
  for (const ScalarLevel& level : levels) {
    if (kind == Reconstruction::trilinear) regions.push_back({level.box(0), level.box(0)});
    if (kind == Reconstruction::blend) regions.push_back({level.box(0), level.box(-1)});
    if (kind == Reconstruction::hat)
      regions.push_back({level.box(1), shrink(level.box(0.5), levels.back().width)});
  }
  return regions;
}

/// As std::floor, which a plain x86-64 has to call.
int floor_of(double x) {
  const int toward_zero = int(x);
  return toward_zero - (toward_zero > x ? 1 : 0);
}

/// Without the upper faces, as in RegionTree.
bool inside(const Box3& box, const Vec3& x) {
  return x.x >= box.min.x && x.y >= box.min.y && x.z >= box.min.z && x.x < box.max.x &&
         x.y < box.max.y && x.z < box.max.z;
}

}  // namespace

const ReconstructionRow& find_reconstruction(std::string_view name) {
  return find_row("reconstruction", name, reconstructions);
}

LevelField::LevelField(std::vector<ScalarLevel> levels, const ReconstructionRow& reconstruction,
                       ValueGaps gaps, const SampleScale& scale)
    : levels_(prepared(std::move(levels), reconstruction.kind)),
      row_(&reconstruction),
      gaps_(std::move(gaps)),
      scale_(scale),
      regions_(regions_of(levels_, row_->kind)),
      tree_(regions_) {
  const std::size_t most =
      row_->kind == Reconstruction::blend ? most_fading : std::tuple_size_v<Cells>;
  if (tree_.most_levels() > most)
    throw InputError(
        fmt::format("{} levels meet at one place; accepted by the reconstruction {}: {}",
                    tree_.most_levels(), row_->name, most));
}

Box3 LevelField::bounds() const {
  Box3 box;
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    box.extend(domain(level).min);
    box.extend(domain(level).max);
  }
  return box;
}

LatticeCell LevelField::cell_at(std::uint32_t level, const Vec3& x) const {
  const Vec3 at = levels_[level].to_lattice(x);
  const int margin = hat() ? 1 : 0;
  LatticeCell cell{level, {}};
  for (int axis = 0; axis < 3; ++axis)
    cell.low[axis] =
        std::clamp(floor_of(at[axis]), -margin, levels_[level].size[axis] - 2 + margin);
  return cell;
}

std::size_t LevelField::cells_at(const Vec3& x, Cells& cells) const {
  if (inside(regions_.front().alone, x)) {  // as the tree would say, of most samples of a surface
    cells[0] = cell_at(0, x);
    return 1;
  }
  std::size_t count = 0;
  bool owned = false;
  for (const std::uint32_t level : tree_.levels_at(x)) {
    if (!regions_[level].support.contains(x)) continue;  // on its upper face, or outside of all
    owned |= domain(level).contains(x);
    cells[count++] = cell_at(level, x);
  }
  return owned ? count : 0;
}

unsigned LevelField::seen_corners(const LatticeCell& cell) const {
  const std::array<int, 3>& size = levels_[cell.level].size;
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    inside &= cell.low[axis] >= 0 && cell.low[axis] + 1 < size[axis];
  if (inside && cell.level == 0) return all_corners;
  unsigned seen = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const std::array<int, 3> at{cell.low[0] + int(i & 1), cell.low[1] + int(i >> 1 & 1),
                                cell.low[2] + int(i >> 2)};
    bool is_sample = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      is_sample &= at[axis] >= 0 && at[axis] < size[axis];
    if (is_sample && !covered(cell.level, at)) seen |= 1u << i;
  }
  return seen;
}

bool LevelField::covered(std::uint32_t level, const std::array<int, 3>& sample) const {
  const Vec3 x = levels_[level].world(Vec3(sample[0], sample[1], sample[2]));
  for (std::uint32_t finer = 0; finer < level; ++finer)
    if (levels_[finer].box(0.5).contains(x)) return true;
  return false;
}

std::optional<double> LevelField::height(const Vec3& x, double value) const {
  Cells cells;
  const std::size_t count = cells_at(x, cells);
  if (count == 0) return std::nullopt;
  const auto [sum, weight] =
      this->sum<double>(std::span(cells).first(count), {x.x, x.y, x.z}, value);
  if (weight == 0) return std::nullopt;  // no hat reaches here
  return sum / weight;
}

std::optional<double> LevelField::value(const Vec3& x) const {
  const double offset = scale_.value(0);
  const std::optional<double> above = height(x, offset);
  return above ? std::optional(scale_.value(*above)) : std::nullopt;
}

std::optional<Vec3> LevelField::gradient(const Vec3& x) const {
  Cells cells;
  const std::size_t count = cells_at(x, cells);
  if (count == 0) return std::nullopt;
  const std::array<Dual, 3> at{{{x.x, Vec3(1, 0, 0)}, {x.y, Vec3(0, 1, 0)}, {x.z, Vec3(0, 0, 1)}}};
  const auto [sum, weight] = this->sum<Dual>(std::span(cells).first(count), at, 0);
  if (weight.value == 0) return std::nullopt;
  return (sum / weight).gradient;
}

std::uint64_t LevelField::bytes() const {
  std::uint64_t bytes = 0;
  for (const ScalarLevel& level : levels_) bytes += level.samples.size() * sizeof(float);
  return bytes;
}

}  // namespace pellucid::fields
