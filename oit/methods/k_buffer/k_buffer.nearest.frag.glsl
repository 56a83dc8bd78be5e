// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts the depth: a place keeps the smaller of two, the larger goes on to the next.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/k_buffer/k_nearest.glsl"

void main() {
  uint d = floatBitsToUint(fragment().depth);
  for (int i = 0; i < LAYERS && d != EMPTY; ++i)
    d = max(d, imageAtomicMin(depths, ivec3(gl_FragCoord.xy, i), d));
}
