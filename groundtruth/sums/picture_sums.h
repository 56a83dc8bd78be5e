// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/progress.h"
#include "core/raster.h"
#include "groundtruth/sums/ray_sums.h"

namespace pellucid::groundtruth {

/// PixelSums say what the rays of a pixel's samples cross (see RaySums), summed to their ends.
struct PixelSums {
  float layers = 0;          // of the sample that has most
  float coverage = 0;        // share of the samples that cross anything
  float transmittance = 0;   // mean over samples, of all layers
  float importance_sum = 0;  // mean of G(1)
  float optical_depth = 0;   // mean of τ(1); infinite where a layer is opaque
  float near = std::numeric_limits<float>::infinity();  // view depth, world units; least of all
  float far = -std::numeric_limits<float>::infinity();  // greatest of all
};

/// Computes the sums of every pixel in double, with scene.samples² rays each; row 0 is the top.
Raster<PixelSums> picture_sums(const scene::Scene& scene, const RayProbe& probe,
                               const Progress& progress);

/// Computes the sums of the rays through the pixels of row y (0 at the top), from the left, at
/// `sample` of each: in pixels from its top left corner, by default its centre.
std::vector<RaySums> row_sums(const scene::Scene& scene, const RayProbe& probe, int y,
                              const Vec2& sample = Vec2(0.5));

}  // namespace pellucid::groundtruth
