// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "compare/measures/hull_distance.h"
#include "compare/measures/study_measures.h"
#include "compare/pictures/error_map.h"
#include "core/parallel.h"
#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {
namespace {

/// Half a step of an 8-bit channel: what is farther off than this can show.
constexpr double visible = 0.5 / 255;

/// 0 where the method saw another number of layers than there are crossings: at the very edge of a
/// triangle it may have drawn other colours than the ray's.
Raster<double> hull_distances(const scene::Scene& scene, const CellMeasurement& cell) {
  const groundtruth::RayProbe probe(scene);
  Raster<double> distances(scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y) {
    const std::vector<groundtruth::RaySums> rays = groundtruth::row_sums(scene, probe, y);
    parallel_for(0, scene.width, [&](int x) {
      const std::vector<groundtruth::RayLayer>& layers = rays[std::size_t(x)].layers;
      const bool same_layers = cell.layers.pixels.empty() || cell.layers.at(x, y) == layers.size();
      if (!same_layers) return;
      std::vector<Vec3> colors{scene.background};
      for (const groundtruth::RayLayer& layer : layers) colors.push_back(layer.color);
      distances.at(x, y) = hull_distance(Vec3(cell.image.at(x, y)), colors);
    });
  }
  return distances;
}

void measure(const MeasuredScene& of, CellMeasurement& cell) {
  const scene::Scene& scene = of.scene;
  const Raster<double> distances = hull_distances(scene, cell);
  const auto& values = distances.pixels;
  const auto outside =
      std::count_if(values.begin(), values.end(), [](double d) { return d > visible; });
  cell.row.measures.push_back({"outside_hull", "Pixels outside the hull of their colours", "",
                               double(outside), scene::Measure::Better::lower});
  cell.row.measures.push_back({"hull_distance_max", "Largest distance to the hull", "",
                               *std::max_element(values.begin(), values.end()),
                               scene::Measure::Better::lower});
  cell.row.pictures.push_back({"hull", "Distance of the colour to the hull of the pixel's colours",
                               ErrorScale::min, ErrorScale::max});
  Image picture(scene.width, scene.height);
  std::transform(values.begin(), values.end(), picture.pixels.begin(),
                 [](double d) { return Rgba(glm::vec3(ErrorScale::color(d)), 1); });
  cell.further.push_back(std::move(picture));
}

}  // namespace

const StudyMeasure& hull_measure() {
  static constexpr StudyMeasure row{"hull", "Distance to the convex hull of a pixel's colours",
                                    measure};
  return row;
}

}  // namespace pellucid::compare
