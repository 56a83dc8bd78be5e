// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace pellucid::groundtruth {

/// PointGroups deal points to groups that lie near each other, a box of the hierarchy each: a
/// hierarchy over groups is a fraction as large as one over points, sooner built and sooner walked.
/// Groups depend on positions and their order alone.
class PointGroups {
 public:
  static constexpr std::uint32_t size = 8;  // points of each group but the last

  /// Sorts fewer than 2^32 points along a Z-order curve through their bounds (G. M. Morton, IBM,
  /// 1966) and cuts it into groups.
  explicit PointGroups(std::span<const Vec3> positions);

  std::uint32_t count() const { return std::uint32_t((order_.size() + size - 1) / size); }
  std::size_t points() const { return order_.size(); }
  /// Returns the indices of a group's points.
  std::span<const std::uint32_t> of(std::uint32_t group) const {
    const std::size_t first = std::size_t(group) * size;
    return std::span(order_).subspan(first, std::min<std::size_t>(size, order_.size() - first));
  }
  std::uint64_t bytes() const { return order_.size() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> order_;
};

}  // namespace pellucid::groundtruth
