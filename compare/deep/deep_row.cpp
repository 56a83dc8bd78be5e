// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/deep/deep_row.h"

#include "groundtruth/sums/front_to_back.h"

namespace pellucid::compare {

DeepRow deep_row(const std::vector<groundtruth::RaySums>& rays) {
  DeepRow row;
  row.counts.reserve(rays.size());
  for (const groundtruth::RaySums& ray : rays) {
    row.counts.push_back(std::uint32_t(ray.layers.size()));
    for (const groundtruth::RayLayer& layer : ray.layers)
      row.layers.push_back({layer.depth, layer.color, layer.opacity, float(layer.importance),
                            layer.object, layer.primitive});
  }
  return row;
}

Rgba composite(std::span<const DeepLayer> layers, const Vec3& background) {
  groundtruth::FrontToBack sum;
  for (const DeepLayer& layer : layers) sum.add(layer.color, layer.opacity);
  // Added to 0 as a sample is to its pixel's sum: -0 becomes 0.
  return Rgba(glm::dvec4(0) + glm::dvec4(sum.over(background), 1 - sum.transmittance));
}

void composite(const DeepRow& row, const Vec3& background, std::span<Rgba> pixels) {
  std::size_t first = 0;
  for (std::size_t x = 0; x < row.counts.size(); ++x) {
    pixels[x] = composite(std::span(row.layers).subspan(first, row.counts[x]), background);
    first += row.counts[x];
  }
}

}  // namespace pellucid::compare
