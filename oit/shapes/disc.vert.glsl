// SPDX-License-Identifier: GPL-3.0-or-later
// A disc as the one triangle around it: a third of its area is cut away by the fragment shader, but
// small discs take the time of their triangles. Points are fetched, so that each is stored once.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"

// Two texels each: position and radius; colour.
layout(binding = points_texture) uniform samplerBuffer points;
uniform uint first_point, stride_of_points;
#ifdef IMPORTANCE
layout(binding = point_importances_texture) uniform samplerBuffer importances;
#endif
#ifdef OPTIMIZED_VERTICES
// The bits of a float.
layout(binding = element_opacities_texture) uniform usamplerBuffer element_opacities;
uniform uint first_point_element, others;  // see element.glsl
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
  vertex_importance = interpolated_importance(texelFetch(importances, point).r);
#endif
#ifdef OPTIMIZED_VERTICES
  vertex_opacity = uintBitsToFloat(texelFetch(element_opacities, int(first_point_element + others) + point).r);
#endif
}
