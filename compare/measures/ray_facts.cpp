// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/ray_facts.h"

#include <algorithm>
#include <span>

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {
namespace {

using Layers = std::span<const groundtruth::RayLayer>;

double shown(const groundtruth::RayLayer& layer) { return layer.opacity * layer.transmittance; }

ContextOfRay context_of(Layers layers, const Vec3& background) {
  const auto first = std::ranges::find_if(
      layers, [](const groundtruth::RayLayer& layer) { return layer.importance >= important; });
  ContextOfRay found{.layers = int(first - layers.begin()), .behind = background};
  for (auto layer = layers.begin(); layer != first; ++layer)
    found.color += layer->color / double(found.layers);
  if (found.layers == 0 || first == layers.end()) return found;
  found.behind = first->color;
  found.gap = first->d - std::prev(first)->d;
  return found;
}

}  // namespace

RayFacts ray_facts(const scene::Scene& scene) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const groundtruth::RayProbe probe(scene);
  const Raster<double> empty(scene.width, scene.height, none);
  RayFacts facts{empty, empty, empty, Raster<ContextOfRay>(scene.width, scene.height)};
  for (int y = 0; y < scene.height; ++y) {
    const std::vector<groundtruth::RaySums> rays = groundtruth::row_sums(scene, probe, y);
    for (int x = 0; x < scene.width; ++x) {
      const auto& layers = rays[std::size_t(x)].layers;
      if (layers.empty()) continue;
      facts.nearest_depth.at(x, y) = layers.front().d;
      facts.shown_depth.at(x, y) = std::ranges::max_element(layers, {}, shown)->d;
      facts.importance.at(x, y) =
          std::ranges::max_element(layers, {}, &groundtruth::RayLayer::importance)->importance;
      facts.context.at(x, y) = context_of(layers, scene.background);
    }
  }
  return facts;
}

}  // namespace pellucid::compare
