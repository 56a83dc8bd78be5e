#pragma once
// CrossingTest for the rays of a packet at once.

#include <array>
#include <cstdint>
#include <vector>

#include "groundtruth/exact_sign.h"

namespace pellucid {

/// Decides which of up to eight rays cross a triangle: to the last bit what their CrossingTests
/// say one by one, with the edge functions of all rays computed side by side. All rays are of one
/// camera.
class PacketTest {
 public:
  static constexpr std::size_t width = 8;

  /// Appends a ray's test as the next lane.
  void add(const CrossingTest& test);

  /// The subset of `lanes` (bit i: lane i) whose rays cross the triangle; `edges` then holds their
  /// edge functions.
  std::uint32_t crosses(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t lanes,
                        std::array<EdgeFunctions, width>& edges) const;

 private:
  using Lanes = std::array<double, width>;

  std::vector<CrossingTest> tests_;
  alignas(64) Lanes x_{}, y_{};
};

}  // namespace pellucid
