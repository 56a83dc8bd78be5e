// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/sums/picture_sums.h"

#include <algorithm>

#include "scene/view/pixel_samples.h"

namespace pellucid::groundtruth {
namespace {

/// Adds a sample of so many.
struct PixelMean {
  double coverage = 0, transmittance = 0, importance_sum = 0, optical_depth = 0;
  PixelSums sums;

  void add(const RaySums& ray, double share) {
    transmittance += share * ray.transmittance;
    if (ray.layers.empty()) return;
    const RayLayer &first = ray.layers.front(), &last = ray.layers.back();
    coverage += share;
    importance_sum += share * last.importance_sum;
    optical_depth += share * last.optical_depth;
    sums.layers = std::max(sums.layers, float(ray.layers.size()));
    sums.near = std::min(sums.near, float(first.depth));
    sums.far = std::max(sums.far, float(last.depth));
  }

  PixelSums rounded() const {
    PixelSums result = sums;
    result.coverage = float(coverage);
    result.transmittance = float(transmittance);
    result.importance_sum = float(importance_sum);
    result.optical_depth = float(optical_depth);
    return result;
  }
};

}  // namespace

Raster<PixelSums> picture_sums(const scene::Scene& scene, const RayProbe& probe,
                               const Progress& progress) {
  const std::vector<Vec2> samples = scene::pixel_samples(scene.samples);
  Raster<PixelSums> picture(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y) {
    report(progress, double(y) / scene.height, "exact sums");
    std::vector<PixelMean> row(scene.width);
    for (const Vec2& sample : samples) {
      const std::vector<RaySums> rays = row_sums(scene, probe, y, sample);
      for (int x = 0; x < scene.width; ++x) row[x].add(rays[x], 1.0 / double(samples.size()));
    }
    for (int x = 0; x < scene.width; ++x) picture.at(x, y) = row[x].rounded();
  }
  return picture;
}

std::vector<RaySums> row_sums(const scene::Scene& scene, const RayProbe& probe, int y,
                              const Vec2& sample) {
  std::vector<Vec2> places;
  for (int x = 0; x < scene.width; ++x) places.emplace_back(x + sample.x, y + sample.y);
  return probe.at(places);
}

}  // namespace pellucid::groundtruth
