// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "compare/study/study.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Returns the part of a given crop that lies in a picture of this size; nothing where none does.
std::optional<Crop> fit_crop(const Crop& crop, int width, int height);

/// Throws InputError "--crop …" for a part that is empty or not within a picture of this size.
void require_inside(const Crop& crop, int width, int height);

/// Returns a part of a raster, within which it lies.
template <class T>
Raster<T> cut(const Raster<T>& raster, const Crop& to) {
  Raster<T> part(to.width, to.height);
  for (int y = 0; y < to.height; ++y)
    std::copy_n(&raster.at(to.x, to.y + y), to.width, &part.at(0, y));
  return part;
}

/// Finds where the pictures differ most: the window, a quarter of the picture on a side, with the
/// largest sum of errors. `error` holds a pixel's error, added up over all the methods.
Crop worst_crop(const Raster<double>& error);

}  // namespace pellucid::compare
