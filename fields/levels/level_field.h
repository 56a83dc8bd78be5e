// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fields/levels/level.h"
#include "fields/levels/region_tree.h"
#include "fields/levels/sample_scale.h"
#include "fields/levels/value_gaps.h"

namespace pellucid::fields {

/// A Reconstruction says how values at samples of several levels become one function of space.
enum class Reconstruction { trilinear, hat, blend };

/// A ReconstructionRow describes one reconstruction: a row of the table.
struct ReconstructionRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  Reconstruction kind;
  bool continuous;         // where the resolution changes, too, of levels within one another
  bool linear_preserving;  // f(x) = x stays f(x) = x
};

/// The table holds every reconstruction.
inline constexpr ReconstructionRow reconstructions[] = {
    {"trilinear", "Trilinear in the finest level alone", "", Reconstruction::trilinear, false,
     true},
    {"hat", "Hat-function basis over the cells that no finer level covers",
     "Wald et al., IEEE VIS 2020; Li, Chen 2023, Eqs. 2, 3", Reconstruction::hat, true, false},
    {"blend", "Trilinear levels, each faded in over its outermost cells", "", Reconstruction::blend,
     true, true}};

/// Returns the row of that name. Throws InputError with the nearest names when there is none.
const ReconstructionRow& find_reconstruction(std::string_view name);

/// A LatticeCell is the cell of a level's lattice of samples whose first corner is the sample
/// `low`. Only for a hat basis corners may lie outside the level. It is not initialized: to clear
/// eight costs a third of a sample.
struct LatticeCell {
  std::uint32_t level;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::array<int, 3> low;
};

/// A LevelSum holds how levels take part at a point: Σ w (f - value) and Σ w, polynomials of degree
/// 3 (blend: 3 n where n levels meet) while the point stays in the same lattice cells. f and value
/// are as samples are kept (SampleScale). The reconstruction is their quotient plus `value`.
/// Weights are never negative, so it lies in the hull of the samples.
template <class T>
struct LevelSum {
  T sum{0.0};
  T weight{0.0};
};

/// At most so many levels may meet at one place where they fade, which bounds the degree of a
/// polynomial along a ray.
constexpr std::size_t most_fading = 5;

/// A LevelField is a scalar field on levels of any boxes and widths, in world coordinates. Where
/// they overlap the finest level rules. It is immutable.
class LevelField {
 public:
  using Cells = std::array<LatticeCell, 8>;

  /// Throws InputError without a level, for a level that check_level() refuses, and when more than
  /// eight levels (blend: five) meet at one place.
  LevelField(std::vector<ScalarLevel> levels, const ReconstructionRow& reconstruction,
             ValueGaps gaps = {}, const SampleScale& scale = {});

  std::span<const ScalarLevel> levels() const { return levels_; }  // the finest first
  const ReconstructionRow& reconstruction() const { return *row_; }
  const SampleScale& scale() const { return scale_; }  // of the levels' samples
  const ValueGaps& gaps() const { return gaps_; }  // values of which the field has no right surface
  /// Returns the box in which values of the level count: its cells for the hat basis, else from its
  /// first to its last sample; in world units. The field is defined in the union of all of them.
  Box3 domain(std::size_t level) const { return levels_[level].box(hat() ? 0.5 : 0); }
  const LevelRegion& region(std::size_t level) const { return regions_[level]; }
  Box3 bounds() const;
  const RegionTree& tree() const { return tree_; }

  /// Finds the lattice cells around x, finest first, and returns their number: 0 outside of every
  /// domain. A coordinate on a sample belongs to the cell above it where there is one.
  std::size_t cells_at(const Vec3& x, Cells& cells) const;
  /// Returns the lattice cell of `level` around x, kept within what the reconstruction reads.
  LatticeCell cell_at(std::uint32_t level, const Vec3& x) const;

  /// Sums over `cells` at the world position x, which may be of any arithmetic: double, Dual, a
  /// polynomial along a ray. `value` is one of the field's.
  template <class T>
  LevelSum<T> sum(std::span<const LatticeCell> cells, const std::array<T, 3>& x,
                  double value) const;

  /// Returns the reconstruction at x, how much it lies above `value`, or its gradient per world
  /// unit; the last two as samples are kept. Nothing outside of every domain.
  ///@{
  std::optional<double> value(const Vec3& x) const;
  std::optional<double> height(const Vec3& x, double value) const;
  std::optional<Vec3> gradient(const Vec3& x) const;
  ///@}

  std::uint64_t bytes() const;

 private:
  bool hat() const { return row_->kind == Reconstruction::hat; }
  /// Says whether cells of a finer level lie over the sample.
  bool covered(std::uint32_t level, const std::array<int, 3>& sample) const;
  /// Returns the bits of those corners of a cell that are samples which nothing finer covers.
  unsigned seen_corners(const LatticeCell& cell) const;
  static constexpr unsigned all_corners = 255;
  /// Returns the samples at a cell's corners, less `kept`, as trilinear_form() takes them.
  std::array<double, 8> corners(const LatticeCell& cell, double kept) const;
  template <class T>
  void add_hats(const LatticeCell& cell, const std::array<T, 3>& s, double kept,
                LevelSum<T>& out) const;

  std::vector<ScalarLevel> levels_;
  const ReconstructionRow* row_;
  ValueGaps gaps_;
  SampleScale scale_;
  std::vector<LevelRegion> regions_;
  RegionTree tree_;
};

}  // namespace pellucid::fields

#include "fields/levels/level_field.inl"
