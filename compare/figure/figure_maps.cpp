// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_maps.h"

#include <fmt/format.h>

#include <cmath>

#include "compare/pictures/error_map.h"
#include "compare/pictures/flip.h"

namespace pellucid::compare {
namespace {

/// So many that no step between two shows.
constexpr int scale_colors = 256;

/// color(share) at shares of the way from the scale's first value to its last.
template <class Color>
Image scale_image(const Color& color) {
  Image image(scale_colors, 1);
  for (int i = 0; i < scale_colors; ++i)
    image.at(i, 0) = Rgba(glm::vec3(color((i + 0.5) / scale_colors)), 1.f);
  return image;
}

FigureScale error_scale() {
  const double decades = std::log10(ErrorScale::max / ErrorScale::min);
  FigureScale scale{"largest RGB difference",
                    scale_image([&](double share) {
                      return ErrorScale::color(ErrorScale::min * std::pow(10, share * decades));
                    }),
                    {}};
  for (int power = -int(decades); power < 0; ++power)
    scale.ticks.push_back(
        {1 + power / decades, {{"10"}, {.text = fmt::format("{}", power), .is_raised = true}}});
  scale.ticks.push_back({1, {{"1"}}});
  return scale;
}

FigureScale flip_scale() {
  Raster<float> values(scale_colors, 1);
  for (int i = 0; i < scale_colors; ++i) values.at(i, 0) = (float(i) + 0.5f) / scale_colors;
  return {"FLIP", flip_picture(values), {{0, {{"0"}}}, {0.5, {{"0.5"}}}, {1, {{"1"}}}}};
}

template <class Map>
std::vector<Image> maps_of(const std::vector<Image>& pictures,
                           const std::vector<bool>& is_reference, const Map& map) {
  std::vector<Image> maps;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    maps.push_back(is_reference[i] ? Image() : map(pictures[i]));
  return maps;
}

}  // namespace

FigureMaps error_maps(const Image& reference, const std::vector<Image>& pictures,
                      const std::vector<bool>& is_reference) {
  return {error_scale(), maps_of(pictures, is_reference, [&](const Image& picture) {
            return error_map(reference, picture);
          })};
}

FigureMaps flip_maps(const Image& reference, const std::vector<Image>& pictures,
                     const std::vector<bool>& is_reference) {
  return {flip_scale(), maps_of(pictures, is_reference, [&](const Image& picture) {
            return flip_picture(flip_map(reference, picture));
          })};
}

}  // namespace pellucid::compare
