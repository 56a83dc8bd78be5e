// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vertices.h"
#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// A VertexBlend is a point between N vertices: their indices, and weights that sum to 1.
template <std::size_t N>
struct VertexBlend {
  std::array<std::uint32_t, N> vertex;
  std::array<double, N> weight;

  Fragment fragment(const geometry::Vertices& vertices) const {
    glm::dvec4 rgba(0);
    for (std::size_t i = 0; i < N; ++i) rgba += weight[i] * glm::dvec4(vertices.colors[vertex[i]]);
    return {Vec3(rgba), rgba.a};
  }

  double importance(const geometry::Vertices& vertices) const {
    if (vertices.importance.empty()) return 0;
    double g = 0;
    for (std::size_t i = 0; i < N; ++i) g += weight[i] * vertices.importance[vertex[i]];
    return g;
  }
};

/// Returns the blend of a point that is a primitive of its own: its vertex alone.
inline VertexBlend<1> point_blend(const Crossing& crossing) { return {{crossing.primitive}, {1}}; }

}  // namespace pellucid::groundtruth
