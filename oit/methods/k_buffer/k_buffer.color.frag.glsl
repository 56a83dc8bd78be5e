// SPDX-License-Identifier: GPL-3.0-or-later
// Stores the colour of a fragment that is among the nearest; sums up the others.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/k_buffer/k_nearest.glsl"

layout(location = 0) out vec4 sums;  // sum of alpha C, sum of alpha
layout(location = 1) out float transmittance;

void main() {
  Fragment f = fragment();
  uint d = floatBitsToUint(f.depth);
  for (int i = 0; i < LAYERS; ++i) {
    ivec3 place = ivec3(gl_FragCoord.xy, i);
    if (imageLoad(depths, place).r == d && imageAtomicCompSwap(depths, place, d, d | CLAIMED) == d) {
      imageStore(colors, place, vec4(f.color, f.alpha));
      discard;
    }
  }
  sums = vec4(f.alpha * f.color, f.alpha);
  transmittance = f.alpha;  // blended into the product of 1 - alpha
}
