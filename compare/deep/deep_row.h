// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "core/vec.h"
#include "groundtruth/sums/ray_sums.h"

namespace pellucid::compare {

/// A DeepLayer is what an exact composite has to know of a crossing, and who crosses.
struct DeepLayer {
  double depth = 0;  // view depth, world units
  Vec3 color{0};     // lit, straight
  double opacity = 0;
  float importance = 0;
  std::uint32_t object = 0;     // index in Scene::objects
  std::uint32_t primitive = 0;  // of the whole object

  /// Orders layers front to back as crossings are ordered. Layers of one primitive at one depth,
  /// which one part has all of, stay as they were in a stable sort.
  friend bool operator<(const DeepLayer& p, const DeepLayer& q) {
    return std::tie(p.depth, p.object, p.primitive) < std::tie(q.depth, q.object, q.primitive);
  }
};

/// A DeepRow is a row of a deep picture.
struct DeepRow {
  std::vector<std::uint32_t> counts;  // of each pixel's layers, from the left
  std::vector<DeepLayer> layers;      // pixel by pixel, front to back
};

/// Returns the row of a picture whose rays these are.
DeepRow deep_row(const std::vector<groundtruth::RaySums>& rays);

/// Composites a pixel's layers, front to back, over the background: bit for bit what `raytrace`
/// makes of a pixel with these crossings and one sample.
Rgba composite(std::span<const DeepLayer> layers, const Vec3& background);

/// Composites every pixel of a row into `pixels`, which has as many elements.
void composite(const DeepRow& row, const Vec3& background, std::span<Rgba> pixels);

}  // namespace pellucid::compare
