// SPDX-License-Identifier: GPL-3.0-or-later
// Adds the fragment to its bin, if this pass keeps it.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/bin_average/bins.glsl"
#include "oit/stage/pixel_lock.glsl"

uniform int first_bin;  // of this pass

void add(ivec3 at, vec4 value) {
  uint count = imageLoad(counts, at).r;
  vec4 sum = count == 0u ? vec4(0.0) : imageLoad(sums, at);
  imageStore(sums, at, sum + value);
  imageStore(counts, at, uvec4(count + 1u));
}

void main() {
  Fragment f = fragment();
  int bin = min(int(f.depth * float(BINS)), BINS - 1) - first_bin;
  if (bin < 0 || bin >= bins_here) discard;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 value = vec4(f.alpha * f.color, f.alpha);
  ONE_AT_A_TIME(pixel, add(ivec3(pixel, bin), value))
}
