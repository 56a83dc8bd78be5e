// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// One resolution of a multi-resolution field: samples at the centres of the cubic cells of a box,
/// axis-aligned. Lattice coordinates count cell widths from the first sample, so that samples lie
/// on whole numbers.
template <class T>
struct Level {
  Vec3 origin{0};    // world, of the first sample
  double width = 1;  // of a cell, world
  std::array<int, 3> size{};
  std::vector<T> samples;  // x fastest

  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) +
           std::size_t(size[0]) * (std::size_t(j) + std::size_t(size[1]) * std::size_t(k));
  }
  const T& at(int i, int j, int k) const { return samples[index(i, j, k)]; }
  Vec3 world(const Vec3& lattice) const { return origin + width * lattice; }
  Vec3 to_lattice(const Vec3& x) const { return (x - origin) / width; }
  /// From the first to the last sample, grown by `margin` cells on every side.
  Box3 box(double margin) const {
    return {world(Vec3(-margin)), world(Vec3(size[0], size[1], size[2]) - 1.0 + margin)};
  }
};

using ScalarLevel = Level<float>;
using VectorLevel = Level<glm::vec3>;

/// Fewest samples of a level along each axis: what one-sided differences of second order need.
constexpr int fewest_samples = 3;

/// Throws InputError "`name`: …" for a level of fewer than three samples along an axis, of a width
/// or origin that is not finite and positive, of another number of samples than its size says, and
/// for a sample that is not finite.
void check_level(const std::string& name, const ScalarLevel& level);
void check_level(const std::string& name, const VectorLevel& level);

}  // namespace pellucid::fields
