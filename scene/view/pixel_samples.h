// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/vec.h"

namespace pellucid::scene {

/// PixelSampling says where a pixel is sampled. Ground truth and every method use the same places,
/// and a pixel is the mean of its samples.
struct PixelSampling {
  int per_axis = 1;  // n: the centres of n × n equal cells, row after row from the top
  /// Above 0 it is the number of frames that take the place of the cells: in each the camera is
  /// moved within the pixel (Baeza Rojo et al. 2019, section 4.2, step 5), by the points 1, 2, … of
  /// Halton's sequence to the bases 2 and 3 (Halton 1960), and the picture is the frames' mean.
  /// More frames go on where fewer end.
  int frames = 0;

  bool is_center() const { return per_axis == 1 && frames == 0; }
  bool operator==(const PixelSampling&) const = default;
};

/// Returns the samples' places, in pixels from the pixel's top left corner.
std::vector<Vec2> pixel_samples(const PixelSampling& sampling);

/// Returns "one sample at each pixel's centre", "2 x 2 samples per pixel, their mean" or "the mean
/// of 8 frames, the camera moved within the pixel".
std::string describe(const PixelSampling& sampling);

}  // namespace pellucid::scene
