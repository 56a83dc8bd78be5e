// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// A LevelRegion says where a level takes part in a reconstruction, and where no coarser one does
/// beside it, as boxes in world units.
struct LevelRegion {
  Box3 support;
  Box3 alone;  // coarser levels have no weight here; may be empty
};

/// A RegionTree is a k-d tree over the boxes of all levels, which may overlap in any way: every
/// leaf lists the levels that take part there (as the bricks of ExaBricks do: Wald et al., IEEE VIS
/// 2020; Li, Chen 2023, Sect. 3.2, which asks for nested boxes). Splits lie on the faces of boxes,
/// so that no face cuts a leaf.
class RegionTree {
 public:
  /// Builds the tree over `regions`, which go from the finest level to the coarsest.
  explicit RegionTree(std::span<const LevelRegion> regions);

  /// Returns the levels that take part at x, finest first; empty where there is none. A point on a
  /// face belongs to the side of larger coordinates.
  std::span<const std::uint32_t> levels_at(const Vec3& x) const;

  /// A Part is a stretch of a ray in which the same levels take part.
  struct Part {
    double begin, end;  // the ray's parameter
    std::span<const std::uint32_t> levels;
  };

  /// Appends the parts of start + t direction, t from `begin` to `end`, in which levels take part,
  /// ascending; where one ends and the next begins is where the ray meets the face between them.
  void append_parts(const Vec3& start, const Vec3& direction, double begin, double end,
                    std::vector<Part>& parts) const;

  /// Returns how many levels the leaf with most of them lists.
  std::size_t most_levels() const;

 private:
  struct Node {
    int axis = -1;               // of a leaf
    double plane = 0;            // x[axis] < plane: the first child
    std::uint32_t a = 0, b = 0;  // children; of a leaf: first level and their count
  };

  std::uint32_t build(const Box3& box, std::span<const LevelRegion> regions);
  std::uint32_t add_leaf(const Vec3& center, std::span<const LevelRegion> regions);

  void append_parts(const Node& node, const Vec3& start, const Vec3& direction, double begin,
                    double end, std::vector<Part>& parts) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> levels_;
};

}  // namespace pellucid::fields
