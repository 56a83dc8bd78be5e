// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::integrators {

/// NearestVertices finds the positions, out of many, that are nearest to a place. Any number of
/// threads may ask at once.
class NearestVertices {
 public:
  /// Copies the positions, world units.
  explicit NearestVertices(std::span<const Vec3> positions);
  ~NearestVertices();
  NearestVertices(const NearestVertices&) = delete;

  /// Returns the numbers of the `count` positions that are nearest to x, the nearest one first; all
  /// of them where they are fewer.
  std::vector<std::uint32_t> around(const Vec3& x, std::size_t count) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace pellucid::integrators
