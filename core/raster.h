// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace pellucid {

/// A Raster is a picture-shaped array of `width` × `height` pixels. Row 0 is the top, column 0 the
/// left; pixels lie row after row.
template <class T>
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<T> pixels;

  Raster() = default;
  Raster(int width_, int height_, const T& fill = T())
      : width(width_), height(height_), pixels(std::size_t(width_) * height_, fill) {}

  T& at(int x, int y) { return pixels[index(x, y)]; }
  const T& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return std::size_t(y) * width + x;
  }
};

/// An Image holds linear colours composited over the background; A = 1 - transmittance.
using Image = Raster<Rgba>;
/// A CountImage holds one number of crossings (layers) per pixel.
using CountImage = Raster<std::uint32_t>;

}  // namespace pellucid
