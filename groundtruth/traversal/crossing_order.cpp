// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/crossing_order.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pellucid::groundtruth {
namespace {

/// Fewer are sorted faster by themselves, and more do not leave the nearest cache.
constexpr std::size_t fewest = 12, most = 512;

/// Deals depths in [low, high] to the buckets 0 … count - 1 without changing their order.
struct Buckets {
  double low, scale;
  std::size_t last;

  std::size_t of(const Crossing& c) const {
    return std::min(last, static_cast<std::size_t>((c.depth - low) * scale));
  }
};

}  // namespace

void order_crossings(std::span<Crossing> crossings) {
  const std::size_t n = crossings.size();
  const auto nearer = [](const Crossing& p, const Crossing& q) { return p.depth < q.depth; };
  if (n < fewest || n > most) return std::sort(crossings.begin(), crossings.end());
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end(), nearer);
  const double scale = double(n) / (high->depth - low->depth);
  // Depths so near, or so far apart, that buckets cannot tell them.
  if (!(scale > 0 && scale < 1e300)) return std::sort(crossings.begin(), crossings.end());
  const Buckets buckets{low->depth, scale, n - 1};

  // Counts, then where each bucket begins, then, once it is filled, where it ends.
  std::array<std::uint16_t, most + 1> ends;
  std::fill_n(ends.begin(), n + 1, 0);
  for (const Crossing& c : crossings) ++ends[buckets.of(c) + 1];
  std::partial_sum(ends.begin(), ends.begin() + n, ends.begin());
  std::array<Crossing, most> dealt;
  for (const Crossing& c : crossings) dealt[ends[buckets.of(c)]++] = c;
  for (std::size_t k = 0, begin = 0; k < n; begin = ends[k++])
    if (ends[k] - begin > 1) std::sort(dealt.begin() + begin, dealt.begin() + ends[k]);
  std::copy_n(dealt.begin(), n, crossings.begin());
}

}  // namespace pellucid::groundtruth
