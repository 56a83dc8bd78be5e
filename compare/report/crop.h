// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "compare/study/study.h"
#include "core/raster.h"

namespace pellucid::compare {

/// The part of a given crop that lies in a picture of this size; at least one pixel.
Crop fit_crop(const Crop& crop, int width, int height);

/// Finds where the pictures differ most: the window, a quarter of the picture on a side, with the
/// largest sum of errors. `error` holds a pixel's error, added up over all the methods.
Crop worst_crop(const Raster<double>& error);

}  // namespace pellucid::compare
