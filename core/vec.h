// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The vector types that every room shares. World quantities are double; float is for pictures and
// for what a float method draws.

#define GLM_FORCE_EXPLICIT_CTOR
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace pellucid {

/// These are vectors and matrices of doubles; matrices are column-major: m[j][i] is row i,
/// column j.
///@{
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
///@}

/// An Rgba is a colour without a transfer curve, red, green and blue, and its opacity A; in floats.
using Rgba = glm::vec4;

/// A Box3 is an axis-aligned box, in world units where nothing else is said. It is empty until it
/// is extended.
struct Box3 {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  static Box3 unbounded() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {Vec3(-infinity), Vec3(infinity)};
  }
  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  bool contains(const Vec3& x) const {
    return x.x >= min.x && x.y >= min.y && x.z >= min.z && x.x <= max.x && x.y <= max.y &&
           x.z <= max.z;
  }
  void extend(const Vec3& x) {
    min = glm::min(min, x);
    max = glm::max(max, x);
  }
  Vec3 center() const { return 0.5 * min + 0.5 * max; }
  double diagonal() const { return glm::length(max - min); }
};

}  // namespace pellucid
