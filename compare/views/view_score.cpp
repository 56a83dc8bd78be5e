// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/views/view_score.h"

#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {
namespace {

constexpr double least_change = 1.0 / 255;

/// Sums over pixels.
struct Tally {
  double covered = 0, layers = 0, visible = 0, importance = 0;

  void add(const groundtruth::RaySums& ray) {
    if (!ray.layers.empty()) ++covered;
    for (const groundtruth::RayLayer& layer : ray.layers) {
      const double seen = layer.opacity * layer.transmittance;
      ++layers;
      if (seen >= least_change) ++visible;
      importance += layer.importance * seen;
    }
  }
};

}  // namespace

ViewScore view_score(const scene::Scene& scene) {
  const groundtruth::RayProbe probe(scene);
  Tally tally;
  for (int y = 0; y < scene.height; ++y)
    for (const groundtruth::RaySums& ray : groundtruth::row_sums(scene, probe, y)) tally.add(ray);
  if (tally.covered == 0) return {};
  const double pixels = double(scene.width) * scene.height;
  return {tally.covered / pixels, tally.visible / tally.covered, 1 - tally.visible / tally.layers,
          tally.importance / pixels};
}

}  // namespace pellucid::compare
