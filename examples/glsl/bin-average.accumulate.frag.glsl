// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/pixel_lock.glsl"

void add(ivec3 at, vec4 value) {
  imageStore(sums, at, imageLoad(sums, at) + value);
  imageStore(counts, at, imageLoad(counts, at) + 1u);
}

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int bin = min(int(f.depth * float(bins)), bins - 1);
  vec4 value = vec4(f.alpha * f.color, f.alpha);
  ONE_AT_A_TIME(pixel, add(ivec3(pixel, bin), value))
}
