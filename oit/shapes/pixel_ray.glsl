// SPDX-License-Identifier: GPL-3.0-or-later
// The direction from the eye through the middle of a pixel of a picture of `size` pixels; view frame,
// unit length.
#include "oit/shapes/view.glsl"

vec3 pixel_ray(ivec2 size) {
#ifdef ORTHOGRAPHIC
  return vec3(0.0, 0.0, 1.0);
#else
  vec2 clip = 2.0 * gl_FragCoord.xy / vec2(size) - 1.0;
  return normalize(vec3((clip - clip_shift) / clip_scale, 1.0));
#endif
}
