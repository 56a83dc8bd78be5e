// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/optical_depth/optical_depth.glsl"

uniform float clamp_alpha;
layout(binding = coefficients_image, r32ui) coherent uniform uimage2DArray bins;  // bits of floats

// OpenGL has no atomic addition of floats: try again until nobody else was faster.
void add(ivec3 at, float x) {
  uint old = imageLoad(bins, at).r, seen;
  do {
    seen = old;
    old = imageAtomicCompSwap(bins, at, seen, floatBitsToUint(uintBitsToFloat(seen) + x));
  } while (old != seen);
}

void main() {
  Fragment f = fragment();
  int bin = min(int(f.depth * float(BINS)), BINS - 1);
  add(ivec3(gl_FragCoord.xy, bin), optical_depth(min(f.alpha, clamp_alpha)));
}
