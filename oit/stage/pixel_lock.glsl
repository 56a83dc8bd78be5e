// SPDX-License-Identifier: GPL-3.0-or-later
// Work on a pixel's images by one fragment at a time, where the driver has no fragment shader
// interlock: a lock per pixel, by compare and swap. It is let go within the loop's body, so that
// fragments of one pixel in one SIMD group get their turns. The lock orders nothing: who is first
// is the driver's choice. A helper invocation's atomics return anything; it does not wait.
#include "oit/gl/bindings.glsl"

layout(binding = locks_image, r32ui) coherent uniform uimage2D locks;  // 0: free

#define ONE_AT_A_TIME(PIXEL, WORK)                                \
  for (bool waiting = !gl_HelperInvocation; waiting;) {           \
    if (imageAtomicCompSwap(locks, PIXEL, 0u, 1u) == 0u) {        \
      WORK;                                                       \
      memoryBarrier();                                            \
      imageAtomicExchange(locks, PIXEL, 0u);                      \
      waiting = false;                                            \
    }                                                             \
  }
