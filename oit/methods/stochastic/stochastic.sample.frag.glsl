// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a fragment with the probability of its opacity; the depth test keeps the nearest.
#include "oit/shapes/fragment.glsl"
#include "oit/stage/random.glsl"

uniform uint sample_index, seed;

layout(location = 0) out vec4 nearest;

void main() {
  Fragment f = fragment();
  uint pixel = hash(uint(gl_FragCoord.x) ^ hash(uint(gl_FragCoord.y)));
  uint number = floatBitsToUint(f.depth) ^ hash(sample_index ^ hash(seed) ^ pixel);
  if (uniform_number(number) >= f.alpha) discard;
  nearest = vec4(f.color, 1.0);
  gl_FragDepth = f.depth;
}
