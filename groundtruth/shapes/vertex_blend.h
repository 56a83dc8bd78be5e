// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "geometry/vertices.h"
#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// A VertexBlend is a point between N vertices: their indices, and weights in [0, 1] that sum to 1
/// but for rounding. Its opacity and its importance lie within the range of the vertices' own,
/// whatever the rounding, so that a constant stays that constant to the last bit: an opacity of 1
/// leaves a transmittance of 0, and 1 - g is never below 0.
template <std::size_t N>
struct VertexBlend {
  std::array<std::uint32_t, N> vertex;
  std::array<double, N> weight;

  Fragment fragment(const geometry::Vertices& vertices) const {
    // Two channels an instruction, which GCC 12 does not make of glm::dvec4 here.
    using Pair = double __attribute__((vector_size(16)));
    Pair rg{0, 0}, ba{0, 0};
    for (std::size_t i = 0; i < N; ++i) {
      const glm::vec4& color = vertices.colors[vertex[i]];
      rg += weight[i] * Pair{color.r, color.g};
      ba += weight[i] * Pair{color.b, color.a};
    }
    return {{rg[0], rg[1], ba[0]},
            held(ba[1], [&](std::uint32_t v) { return vertices.colors[v].a; })};
  }

  double importance(const geometry::Vertices& vertices) const {
    if (vertices.importance.empty()) return 0;
    double g = 0;
    for (std::size_t i = 0; i < N; ++i) g += weight[i] * vertices.importance[vertex[i]];
    return held(g, [&](std::uint32_t v) { return vertices.importance[v]; });
  }

 private:
  /// Holds a weighted sum to the range of its values. To start at one vertex and add differences
  /// would keep constants, too, but not the range, and would single a vertex out.
  template <class ValueOf>
  double held(double sum, const ValueOf& value_of) const {
    float least = value_of(vertex[0]), most = least;
    for (std::size_t i = 1; i < N; ++i) {
      least = std::min(least, value_of(vertex[i]));
      most = std::max(most, value_of(vertex[i]));
    }
    return std::clamp(sum, double(least), double(most));
  }
};

/// Returns the blend of a point that is a primitive of its own: its vertex alone.
inline VertexBlend<1> point_blend(const Crossing& crossing) { return {{crossing.primitive}, {1}}; }

}  // namespace pellucid::groundtruth
