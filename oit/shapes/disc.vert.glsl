// SPDX-License-Identifier: GPL-3.0-or-later
// A disc as the one triangle around it: a third of its area is cut away by the fragment shader, but
// small discs take the time of their triangles. Points are fetched, so that each is stored once.
#include "oit/shapes/view.glsl"

layout(binding = 14) uniform samplerBuffer points;  // two texels each: position and radius; colour
uniform uint first_point, stride_of_points;

layout(location = 0) flat out vec4 vertex_color;
layout(location = 1) flat out float vertex_depth;
layout(location = 2) out vec2 vertex_corner;  // units of the radius from the centre
#ifdef IMPORTANCE
layout(binding = 13) uniform samplerBuffer importances;
layout(location = 5) flat out float vertex_importance;
#endif
#ifdef OPTIMIZED_VERTICES
layout(binding = 11) uniform usamplerBuffer element_opacities;  // the bits of a float
uniform uint first_point_element;
layout(location = 6) flat out float vertex_opacity;
#endif

// Of an equilateral triangle around the unit circle.
vec2 corner(int i) {
  const float root3 = 1.7320508075688772;
  return i == 0 ? vec2(0.0, 2.0) : vec2(i == 1 ? -root3 : root3, -1.0);
}

void main() {
  int point = int(first_point) + gl_VertexID / 3 * int(stride_of_points);
  vec4 center = texelFetch(points, 2 * point);
  vertex_corner = corner(gl_VertexID % 3);
  gl_Position = clip_position(vec3(center.xy + center.w * vertex_corner, center.z));
  vertex_color = texelFetch(points, 2 * point + 1);
  vertex_depth = center.z;
#ifdef IMPORTANCE
  vertex_importance = texelFetch(importances, point).r;
#endif
#ifdef OPTIMIZED_VERTICES
  vertex_opacity = uintBitsToFloat(texelFetch(element_opacities, int(first_point_element) + point).r);
#endif
}
