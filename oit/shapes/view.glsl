// SPDX-License-Identifier: GPL-3.0-or-later
// From the frame of the vertices to clip space, the same for every vertex of a picture.
//
// The frame: x right and y up in view units, the eye at 0; in place of z the depth d of the scene.
#ifndef VIEW
#define VIEW
#include "oit/gl/bindings.glsl"

layout(binding = view_block, std140) uniform View {
  vec2 clip_scale;  // from view units to clip space; y points down: row 0 is the top
  vec2 clip_shift;  // moves the picture so that a sample lies at a pixel's centre; clip units
  vec2 clip_w;      // w = clip_w.x + clip_w.y d
  vec2 clip_z;      // likewise z, chosen so that only what lies behind the eye is clipped
  // For rays, in double:
  dvec2 ray_scale;   // from clip space to view units at a view depth of 1 (orthographic: at any)
  dvec2 ray_shift;   // clip_shift
  dvec2 view_depth;  // of d = 0; of a d of 1 less that: view units
};

float view_w(float d) { return clip_w.x + clip_w.y * d; }

vec4 clip_position(vec3 position) {
  float w = view_w(position.z);
  return vec4(position.xy * clip_scale + w * clip_shift, clip_z.x + clip_z.y * position.z, w);
}
#endif
