// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace pellucid::integrators {

/// Makes `count` lines of at most `budget` vertices together: make(i, most) returns line i with at
/// most so many `points`, and says by `is_cut` whether it would have had more. All lines have the
/// same share; while what complete ones leave over doubles that of the others, these are made
/// again. So who is cut, and where, does not depend on threads.
template <class Line, class Make>
std::vector<Line> lines_within(std::uint64_t budget, std::size_t count, const Make& make) {
  std::vector<Line> lines(count);
  std::vector<std::size_t> open(count);
  std::iota(open.begin(), open.end(), std::size_t(0));
  for (std::uint64_t share = budget / count;;) {
    parallel_for(std::size_t(0), open.size(),
                 [&](std::size_t k) { lines[open[k]] = make(open[k], share); });
    std::erase_if(open, [&](std::size_t i) { return !lines[i].is_cut; });
    if (open.empty()) return lines;
    std::uint64_t left = budget;
    for (const Line& line : lines)
      if (!line.is_cut) left -= line.points.size();
    const std::uint64_t next = left / open.size();
    if (next < 2 * share) return lines;
    share = next;
  }
}

}  // namespace pellucid::integrators
