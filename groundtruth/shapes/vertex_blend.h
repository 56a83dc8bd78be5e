// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vertices.h"
#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// A VertexBlend is a point between N vertices: their indices, and weights in [0, 1] that sum to 1
/// but for rounding. Its values lie within the range of the vertices' values, whatever the
/// rounding, so that a constant stays that constant to the last bit: an opacity of 1 leaves a
/// transmittance of 0, and 1 - g is never below 0.
template <std::size_t N>
struct VertexBlend {
  std::array<std::uint32_t, N> vertex;
  std::array<double, N> weight;

  Fragment fragment(const geometry::Vertices& vertices) const {
    const auto rgba = blend([&](std::uint32_t v) { return glm::dvec4(vertices.colors[v]); });
    return {Vec3(rgba), rgba.a};
  }

  double importance(const geometry::Vertices& vertices) const {
    if (vertices.importance.empty()) return 0;
    return blend([&](std::uint32_t v) { return double(vertices.importance[v]); });
  }

 private:
  /// Returns the weighted sum, held to the range. To start at one vertex and add differences would
  /// keep constants, too, but not the range, and would single a vertex out.
  template <class ValueOf>
  auto blend(const ValueOf& value_of) const {
    auto sum = weight[0] * value_of(vertex[0]);
    auto least = value_of(vertex[0]), most = least;
    for (std::size_t i = 1; i < N; ++i) {
      const auto value = value_of(vertex[i]);
      sum += weight[i] * value;
      least = glm::min(least, value);
      most = glm::max(most, value);
    }
    return glm::clamp(sum, least, most);
  }
};

/// Returns the blend of a point that is a primitive of its own: its vertex alone.
inline VertexBlend<1> point_blend(const Crossing& crossing) { return {{crossing.primitive}, {1}}; }

}  // namespace pellucid::groundtruth
