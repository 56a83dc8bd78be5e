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

/// Puts few crossings of different depths in their order: the place of each is the number of those
/// that are nearer. No branch depends on depths, which processors cannot foretell. Returns false,
/// and leaves them as they are, where depths are equal.
bool sort_by_rank(std::span<Crossing> crossings) {
  const std::size_t n = crossings.size();
  std::array<double, fewest> depth;
  std::array<Crossing, fewest> found;
  for (std::size_t i = 0; i < n; ++i) {
    found[i] = crossings[i];
    depth[i] = found[i].depth;
  }
  std::array<std::uint32_t, fewest> place;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t nearer = 0;
    for (std::size_t k = 0; k < n; ++k) nearer += depth[k] < depth[i];
    place[i] = nearer;
    sum += nearer;
  }
  if (sum != n * (n - 1) / 2) return false;  // a pair of which neither is nearer
  for (std::size_t i = 0; i < n; ++i) crossings[place[i]] = found[i];
  return true;
}

void sort(std::span<Crossing> crossings) {
  if (crossings.size() <= fewest && sort_by_rank(crossings)) return;
  std::sort(crossings.begin(), crossings.end());
}

}  // namespace

void order_crossings(std::span<Crossing> crossings) {
  const std::size_t n = crossings.size();
  const auto nearer = [](const Crossing& p, const Crossing& q) { return p.depth < q.depth; };
  if (n <= fewest || n > most) return sort(crossings);
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end(), nearer);
  const double scale = double(n) / (high->depth - low->depth);
  // Depths so near, or so far apart, that buckets cannot tell them.
  if (!(scale > 0 && scale < 1e300)) return sort(crossings);
  const Buckets buckets{low->depth, scale, n - 1};

  // Counts, then where each bucket begins, then, once it is filled, where it ends.
  std::array<std::uint16_t, most + 1> ends;
  std::fill_n(ends.begin(), n + 1, 0);
  for (const Crossing& c : crossings) ++ends[buckets.of(c) + 1];
  std::partial_sum(ends.begin(), ends.begin() + n, ends.begin());
  std::array<Crossing, most> dealt;
  for (const Crossing& c : crossings) dealt[ends[buckets.of(c)]++] = c;
  for (std::size_t k = 0, begin = 0; k < n; begin = ends[k++]) {
    const std::span bucket = std::span(dealt).subspan(begin, ends[k] - begin);
    if (bucket.size() > 2) sort(bucket);
    if (bucket.size() == 2 && bucket[1] < bucket[0]) std::swap(bucket[0], bucket[1]);
  }
  std::copy_n(dealt.begin(), n, crossings.begin());
}

}  // namespace pellucid::groundtruth
