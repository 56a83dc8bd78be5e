// SPDX-License-Identifier: GPL-3.0-or-later
// The bins of depth that one pass keeps.
#include "oit/gl/bindings.glsl"

// Sum of alpha C, sum of alpha. Undefined where the count is 0.
layout(binding = bin_sums_image, rgba32f) coherent uniform image2DArray sums;
layout(binding = bin_counts_image, r32ui) coherent uniform uimage2DArray counts;  // fragments

uniform int bins_here;  // of this pass

// Premultiplied. Nothing for a bin without fragments.
vec4 mean_of_bin(ivec3 at) {
  uint count = imageLoad(counts, at).r;
  return count == 0u ? vec4(0.0) : imageLoad(sums, at) / float(count);
}
