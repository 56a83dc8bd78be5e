// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace pellucid::integrators {

/// DisjointSets tell which set a thing is in, when sets are joined pair by pair.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) { grow(size); }

  /// Adds things, each in a set of its own, until there are `size`.
  void grow(std::size_t size) {
    const std::size_t known = parents_.size();
    if (size <= known) return;
    parents_.resize(size);
    std::iota(parents_.begin() + std::ptrdiff_t(known), parents_.end(), known);
  }
  /// Returns one thing that stands for the set that i is in.
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace pellucid::integrators
