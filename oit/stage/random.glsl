// SPDX-License-Identifier: GPL-3.0-or-later
// A hash as a source of random numbers, for GLSL and, through GLM, for C++: the 32-bit finalizer
// "lowbias32" (Wellons 2018), whose every output bit depends on every input bit.
uint hash(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

// In [0, 1).
float uniform_number(uint x) { return float(hash(x) >> 8) * (1.0f / 16777216.0f); }
