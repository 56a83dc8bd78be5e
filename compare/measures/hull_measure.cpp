// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "compare/measures/hull_distance.h"
#include "compare/measures/study_measures.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "core/parallel.h"
#include "groundtruth/sums/picture_sums.h"

namespace pellucid::compare {
namespace {

/// Half a step of an 8-bit channel: what is farther off than this can show.
constexpr double visible = 0.5 / 255;

/// Whether all values are steps of 8 bits, as of a picture from a PNG.
bool is_of_bytes(const Image& image) {
  const Image bytes = displayed_values(image);
  return std::ranges::equal(image.pixels, bytes.pixels, [](const Rgba& a, const Rgba& b) {
    return glm::all(glm::lessThan(glm::abs(glm::vec3(a) - glm::vec3(b)), glm::vec3(1e-6f)));
  });
}

/// The colours, each moved by all that rounding may have added to a channel of the pixel: half a
/// step of 8 bits either way, and whatever is cut off above 1. The pixel lies in their hull where a
/// colour of the hull is rounded to it.
std::vector<Vec3> before_rounding(std::span<const Vec3> colors, const Vec3& pixel) {
  Vec3 most(visible);
  for (int c = 0; c < 3; ++c)
    if (pixel[c] > 1 - visible)
      for (const Vec3& color : colors) most[c] = std::max(most[c], color[c] - pixel[c]);
  std::vector<Vec3> moved;
  for (const Vec3& color : colors)
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vec3 at = color;
      for (int c = 0; c < 3; ++c) at[c] += corner & (1u << c) ? visible : -most[c];
      moved.push_back(at);
    }
  return moved;
}

/// A rasterizer snaps vertices, llvmpipe to 1/256 of a pixel: at the very edge of a primitive it
/// draws what a ray so far from the pixel's centre crosses. Adds those rays' colours.
void add_colors_beside(const groundtruth::RayProbe& probe, int x, int y,
                       std::vector<Vec3>& colors) {
  constexpr double snap = 1. / 256;
  for (const double dy : {-snap, 0., snap})
    for (const double dx : {-snap, 0., snap})
      for (const auto& layer : probe.at(x + 0.5 + dx, y + 0.5 + dy).layers)
        colors.push_back(layer.color);
}

/// Not a number where the method saw another number of layers than there are crossings: at the very
/// edge of a triangle it may have drawn other colours than the ray's.
Raster<double> hull_distances(const scene::Scene& scene, const CellMeasurement& cell) {
  const groundtruth::RayProbe probe(scene);
  const bool rounded = !cell.row.given.empty() && is_of_bytes(cell.image);
  Raster<double> distances(scene.width, scene.height, std::numeric_limits<double>::quiet_NaN());
  for (int y = 0; y < scene.height; ++y) {
    const std::vector<groundtruth::RaySums> rays = groundtruth::row_sums(scene, probe, y);
    parallel_for(0, scene.width, [&](int x) {
      const std::vector<groundtruth::RayLayer>& layers = rays[std::size_t(x)].layers;
      const bool same_layers = cell.layers.pixels.empty() || cell.layers.at(x, y) == layers.size();
      if (!same_layers) return;
      std::vector<Vec3> colors{scene.background};
      for (const groundtruth::RayLayer& layer : layers) colors.push_back(layer.color);
      const Vec3 pixel(cell.image.at(x, y));
      const auto distance = [&] {
        return hull_distance(pixel, rounded ? before_rounding(colors, pixel) : colors);
      };
      distances.at(x, y) = distance();
      if (distances.at(x, y) <= visible) return;
      add_colors_beside(probe, x, y, colors);
      distances.at(x, y) = distance();
    });
  }
  return distances;
}

void measure(const MeasuredScene& of, CellMeasurement& cell) {
  const scene::Scene& scene = of.scene;
  const Raster<double> distances = hull_distances(scene, cell);
  const auto& values = distances.pixels;
  if (std::ranges::all_of(values, [](double d) { return std::isnan(d); })) return;
  const auto outside =
      std::count_if(values.begin(), values.end(), [](double d) { return d > visible; });
  cell.row.measures.push_back({"outside_hull", "Pixels outside the hull of their colours", "",
                               double(outside), scene::Measure::Better::lower});
  cell.row.measures.push_back({"hull_distance_max", "Largest distance to the hull", "",
                               std::accumulate(values.begin(), values.end(), 0.,
                                               [](double a, double b) { return std::fmax(a, b); }),
                               scene::Measure::Better::lower});
  cell.row.pictures.push_back({"hull", "Distance of the colour to the hull of the pixel's colours",
                               ErrorScale::min, ErrorScale::max});
  Image picture(scene.width, scene.height);
  std::transform(values.begin(), values.end(), picture.pixels.begin(),
                 [](double d) { return Rgba(glm::vec3(ErrorScale::color(std::fmax(d, 0))), 1); });
  cell.further.push_back(std::move(picture));
}

}  // namespace

const StudyMeasure& hull_measure() {
  static constexpr StudyMeasure row{"hull", "Distance to the convex hull of a pixel's colours",
                                    measure};
  return row;
}

}  // namespace pellucid::compare
