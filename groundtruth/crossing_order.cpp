#include "groundtruth/crossing_order.h"

#include <algorithm>
#include <array>

namespace pellucid {
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

void order_crossings(std::vector<Crossing>& crossings, std::vector<Crossing>& scratch) {
  const std::size_t n = crossings.size();
  const auto nearer = [](const Crossing& p, const Crossing& q) { return p.depth < q.depth; };
  if (n < fewest || n > most) return std::sort(crossings.begin(), crossings.end());
  const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end(), nearer);
  const double scale = double(n) / (high->depth - low->depth);
  // Equal depths, or so near that their bucket cannot be told.
  if (!(scale < 1e300)) return std::sort(crossings.begin(), crossings.end());
  const Buckets buckets{low->depth, scale, n - 1};

  std::array<std::uint16_t, most + 1> ends{};  // of each bucket, once they are filled
  for (const Crossing& c : crossings) ++ends[buckets.of(c) + 1];
  for (std::size_t k = 1; k <= n; ++k) ends[k] += ends[k - 1];
  scratch.resize(n);
  for (const Crossing& c : crossings) scratch[ends[buckets.of(c)]++] = c;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (ends[k] - begin > 1) std::sort(scratch.begin() + begin, scratch.begin() + ends[k]);
    begin = ends[k];
  }
  crossings.swap(scratch);
}

}  // namespace pellucid
