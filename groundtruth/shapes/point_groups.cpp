// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/point_groups.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"

namespace pellucid::groundtruth {
namespace {

constexpr int bits = 21;       // of an axis; three of them fill a key
constexpr int hand_bits = 12;  // of a key

/// A point with its place on the curve.
struct Placed {
  std::uint64_t key;
  std::uint32_t point;

  friend bool operator<(const Placed& p, const Placed& q) {
    return p.key != q.key ? p.key < q.key : p.point < q.point;
  }
};

/// Spreads the 21 low bits of a number, two zeros after each.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

/// Which of 2^21 equal parts of the range holds a coordinate.
std::uint64_t part_of(double x, double low, double high) {
  constexpr double parts = 1 << bits;
  if (!(high > low)) return 0;
  const double share = (0.5 * x - 0.5 * low) / (0.5 * high - 0.5 * low);  // also of all doubles
  return std::uint64_t(std::min(parts * share, parts - 1));
}

std::uint64_t key_of(const Vec3& x, const Box3& box) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key |= spread(part_of(x[axis], box.min[axis], box.max[axis])) << axis;
  return key;
}

}  // namespace

PointGroups::PointGroups(std::span<const Vec3> positions) : order_(positions.size()) {
  Box3 box;
  for (const Vec3& x : positions) box.extend(x);
  std::vector<std::uint64_t> keys(positions.size());
  parallel_for(std::size_t(0), keys.size(),
               [&](std::size_t i) { keys[i] = key_of(positions[i], box); });
  // Dealt by the first bits of their keys, counted first, then each hand sorted by itself.
  const auto hand = [&](std::uint64_t key) { return std::size_t(key >> (3 * bits - hand_bits)); };
  std::vector<std::size_t> ends((std::size_t(1) << hand_bits) + 1);
  for (const std::uint64_t key : keys) ++ends[hand(key) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  const std::vector<std::size_t> begins(ends.begin(), ends.end() - 1);
  std::vector<Placed> placed(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    placed[ends[hand(keys[i])]++] = {keys[i], std::uint32_t(i)};
  parallel_for(std::size_t(0), begins.size(), [&](std::size_t k) {
    std::sort(placed.begin() + std::ptrdiff_t(begins[k]), placed.begin() + std::ptrdiff_t(ends[k]));
    for (std::size_t i = begins[k]; i < ends[k]; ++i) order_[i] = placed[i].point;
  });
}

}  // namespace pellucid::groundtruth
