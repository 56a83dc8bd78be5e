// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/elements/elements.h"

#include <algorithm>

namespace pellucid::scene {
namespace {

float mean_of(std::span<const std::uint32_t> elements, const std::vector<float>& opacities) {
  float sum = 0;
  for (const std::uint32_t element : elements) sum += opacities[element];
  return sum / float(elements.size());
}

/// Held to the range of what it mixes: weights add up to 1 but for rounding, and elements that all
/// stay opaque leave the vertex so.
float weighted_mean(std::span<const std::uint32_t> elements, const float* weights,
                    const std::vector<float>& opacities) {
  float sum = 0, least = opacities[elements.front()], most = least;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const float opacity = opacities[elements[k]];
    sum += weights[k] * opacity;
    least = std::min(least, opacity);
    most = std::max(most, opacity);
  }
  return std::clamp(sum, least, most);
}

std::uint64_t bytes_of(const Rows& rows) {
  return rows.offsets.size() * sizeof rows.offsets[0] + rows.values.size() * sizeof rows.values[0];
}

}  // namespace

std::uint64_t Elements::bytes() const {
  return of_primitive.size() * sizeof of_primitive[0] + bytes_of(neighbours) + bytes_of(of_vertex) +
         weights.size() * sizeof weights[0];
}

void smooth(const Elements& elements, int iterations, std::vector<float>& opacities) {
  std::vector<float> next(opacities.size());
  for (int iteration = 0; iteration < iterations; ++iteration) {
    for (std::size_t i = 0; i < opacities.size(); ++i) {
      const auto neighbours = elements.neighbours[i];
      const float mean = neighbours.empty() ? opacities[i] : mean_of(neighbours, opacities);
      next[i] = 0.5f * (opacities[i] + mean);
    }
    opacities.swap(next);
  }
}

std::vector<float> vertex_opacities(const Elements& elements, const std::vector<float>& opacities) {
  const Rows& rows = elements.of_vertex;
  std::vector<float> result(rows.count(), 1.0f);
  for (std::size_t v = 0; v < result.size(); ++v)
    if (!rows[v].empty())
      result[v] = weighted_mean(rows[v], &elements.weights[rows.offsets[v]], opacities);
  return result;
}

}  // namespace pellucid::scene
