// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/vec.h"

namespace pellucid {

/// Random numbers that are a function of seed, element and channel alone, so that elements can be
/// made in any order and by any number of threads. Channels of one element are independent.
/// splitmix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
class IndexedRandom {
 public:
  IndexedRandom(std::uint64_t seed, std::uint64_t element)
      : state_(mix(mix(seed + golden) + element)) {}

  /// In [0, 1), 53 bits.
  double uniform(std::uint64_t channel) const {
    return double(mix(state_ + (channel + 1) * golden) >> 11) * 0x1p-53;
  }
  double uniform(std::uint64_t channel, double low, double high) const {
    return low + (high - low) * uniform(channel);
  }
  std::uint64_t below(std::uint64_t channel, std::uint64_t n) const {
    return std::uint64_t(uniform(channel) * double(n));
  }
  /// Takes three channels.
  Vec3 in_box(std::uint64_t channel, const Box3& box) const {
    return box.min +
           Vec3(uniform(channel), uniform(channel + 1), uniform(channel + 2)) * (box.max - box.min);
  }
  /// Standard normal, by Box and Muller 1958; takes two channels.
  double normal(std::uint64_t channel) const {
    return radius(channel) * std::cos(2 * std::numbers::pi * uniform(channel + 1));
  }
  /// Takes six channels.
  Vec3 normal3(std::uint64_t channel) const {
    return {normal(channel), normal(channel + 2), normal(channel + 4)};
  }
  /// On the unit sphere; takes two channels.
  Vec3 direction(std::uint64_t channel) const {
    const double z = uniform(channel, -1, 1), phi = 2 * std::numbers::pi * uniform(channel + 1);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;

  static constexpr std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }
  double radius(std::uint64_t channel) const {
    return std::sqrt(-2 * std::log(1 - uniform(channel)));
  }

  std::uint64_t state_;
};

}  // namespace pellucid
