// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vec.h"

namespace pellucid::scene {

/// Returns where a pixel is sampled, in pixels from its top left corner: the centres of n × n equal
/// cells, row after row from the top. Ground truth and every method use these; a pixel is the mean
/// of its samples.
inline std::vector<Vec2> pixel_samples(int n) {
  std::vector<Vec2> samples;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) samples.emplace_back((x + 0.5) / n, (y + 0.5) / n);
  return samples;
}

}  // namespace pellucid::scene
