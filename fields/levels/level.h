// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::fields {

/// A Level is one resolution of a multi-resolution field: samples at the centres of the cubic cells
/// of a box, axis-aligned. Lattice coordinates count cell widths from the first sample, so that
/// samples lie on whole numbers.
template <class T>
struct Level {
  Vec3 origin{0};             // world, of the first sample
  double width = 1;           // of a cell, world
  std::array<int, 3> size{};  // samples along x, y, z
  std::vector<T> samples;     // x fastest

  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) +
           std::size_t(size[0]) * (std::size_t(j) + std::size_t(size[1]) * std::size_t(k));
  }
  const T& at(int i, int j, int k) const { return samples[index(i, j, k)]; }
  Vec3 world(const Vec3& lattice) const { return origin + width * lattice; }
  Vec3 to_lattice(const Vec3& x) const { return (x - origin) / width; }
  /// Returns the box from the first to the last sample, grown by `margin` cells on every side, in
  /// world units.
  Box3 box(double margin) const {
    return {world(Vec3(-margin)), world(Vec3(size[0], size[1], size[2]) - 1.0 + margin)};
  }
};

/// A ScalarLevel has one number a sample.
using ScalarLevel = Level<float>;
/// A VectorLevel has one velocity a sample, in world units per unit of time.
using VectorLevel = Level<glm::vec3>;
/// The same of numbers that are not all floats.
///@{
using DoubleLevel = Level<double>;
using DoubleVectorLevel = Level<Vec3>;
///@}

/// A level has at least so many samples along each axis: one-sided differences of second order need
/// them.
constexpr int fewest_samples = 3;

/// Throws InputError "`name`: …" for a level of fewer than three samples along an axis, of a width
/// that is not finite and positive, an origin that is not finite, or another number of samples than
/// its size says, and for a sample that is not finite.
///@{
void check_level(const std::string& name, const ScalarLevel& level);
void check_level(const std::string& name, const VectorLevel& level);
void check_level(const std::string& name, const DoubleLevel& level);
void check_level(const std::string& name, const DoubleVectorLevel& level);
///@}

}  // namespace pellucid::fields
