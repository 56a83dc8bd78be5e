// SPDX-License-Identifier: GPL-3.0-or-later
// The importance of a fragment, (g, 1 - g), in 32 bits: the smaller of both, and in the sign's bit
// which one it is, so that neither loses what it has of a float's digits near 0.
uint pack_importance(vec2 g) {
  return g.x < g.y ? floatBitsToUint(g.x) : floatBitsToUint(g.y) | 0x80000000u;
}

vec2 unpack_importance(uint bits) {
  float smaller = uintBitsToFloat(bits & 0x7fffffffu);
  return (bits >> 31) == 0u ? vec2(smaller, 1.0 - smaller) : vec2(1.0 - smaller, smaller);
}
