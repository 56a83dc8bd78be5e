// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/ray_facts.h"

#include <algorithm>
#include <limits>

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {

RayFacts ray_facts(const scene::Scene& scene) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const groundtruth::RayProbe probe(scene);
  RayFacts facts{Raster<double>(scene.width, scene.height, none),
                 Raster<double>(scene.width, scene.height, none)};
  for (int y = 0; y < scene.height; ++y) {
    const std::vector<groundtruth::RaySums> rays = groundtruth::row_sums(scene, probe, y);
    for (int x = 0; x < scene.width; ++x) {
      const auto& layers = rays[std::size_t(x)].layers;
      if (layers.empty()) continue;
      facts.nearest_depth.at(x, y) = layers.front().d;
      facts.importance.at(x, y) =
          std::ranges::max_element(layers, {}, &groundtruth::RayLayer::importance)->importance;
    }
  }
  return facts;
}

}  // namespace pellucid::compare
