// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scene/appearance/colormap.h"

namespace pellucid::compare {

Vec3 logarithmic_color(double value, double min, double max) {
  static const scene::ColormapRow& map = scene::find_colormap("magma");
  return map(std::log(std::max(value, min) / min) / std::log(max / min));
}

double pixel_error(const Rgba& a, const Rgba& b) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(double(b[c]) - a[c]));
  return largest;
}

Image error_map(const Image& reference, const Image& test) {
  assert(reference.width == test.width && reference.height == test.height);
  Image map(test.width, test.height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const double error = pixel_error(reference.pixels[i], test.pixels[i]);
    map.pixels[i] = Rgba(glm::vec3(ErrorScale::color(error)), 1.f);
  }
  return map;
}

PictureForm form_of_error_map() {
  return form_of_map(
      fmt::format("largest error of red, green and blue, as colours, logarithmic "
                  "from {} to {}",
                  ErrorScale::min, ErrorScale::max));
}

}  // namespace pellucid::compare
