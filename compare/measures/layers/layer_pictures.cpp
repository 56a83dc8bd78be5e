// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measures/layers/layer_pictures.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <vector>

#include "compare/pictures/error_map.h"

namespace pellucid::compare {
namespace {

constexpr double most_layers = 32;     // that the scale tells apart
constexpr std::int64_t farthest = 16;  // difference of the histogram: the last bars have all beyond

/// Colours of numbers by pixel on a logarithmic scale; 0 is white.
void add_picture(const char* name, const char* title, const CountImage& counts,
                 CellMeasurement& measured) {
  const RowPicture scale{name, title, 1, most_layers};
  Image picture(counts.width, counts.height, Rgba(1));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    if (const std::uint32_t n = counts.pixels[i])
      picture.pixels[i] = Rgba(glm::vec3(logarithmic_color(n, scale.min, scale.max)), 1);
  measured.row.pictures.push_back(scale);
  measured.further.push_back(std::move(picture));
}

}  // namespace

void add_layer_picture(CellMeasurement& measured) {
  add_picture("layers", "Layers per pixel", measured.layers, measured);
}

void add_layer_difference(const CountImage& reference, CellMeasurement& measured) {
  assert(reference.pixels.size() == measured.layers.pixels.size());
  CountImage amounts(reference.width, reference.height);
  RowCurve histogram{"layers more than the reference",
                     "",
                     "Pixels by their layers more than the reference",
                     "layers more than the reference",
                     "pixels",
                     {},
                     {}};
  for (std::int64_t by = -farthest; by <= farthest; ++by) histogram.x.push_back(double(by));
  histogram.y.assign(histogram.x.size(), 0);
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const std::int64_t here = measured.layers.pixels[i], there = reference.pixels[i];
    amounts.pixels[i] = std::uint32_t(std::abs(here - there));
    if (here > 0 || there > 0)
      ++histogram.y[std::size_t(std::clamp(here - there, -farthest, farthest) + farthest)];
  }
  add_picture("layer-difference", "Difference of layers from the reference", amounts, measured);
  measured.row.curves.push_back(std::move(histogram));
}

}  // namespace pellucid::compare
