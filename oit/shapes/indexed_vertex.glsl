// SPDX-License-Identifier: GPL-3.0-or-later
// A vertex of a mesh or of a ribbon: what its attributes say is handed on.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"

layout(location = position_attribute) in vec3 position;  // see view.glsl
layout(location = color_attribute) in vec4 color;        // straight colour, opacity
#ifdef LIT
#ifdef RIBBON
layout(location = direction_attribute) in vec4 direction;  // and from -1 to 1 across
#else
layout(location = direction_attribute) in vec3 direction;  // as vertex_direction; unit length
#endif
#endif
#ifdef IMPORTANCE
layout(location = importance_attribute) in float importance;
#endif
#ifdef OPTIMIZED_VERTICES
layout(location = opacity_attribute) in float opacity;
#endif

void hand_on_vertex() {
  gl_Position = clip_position(position);
  vertex_color = color;
  vertex_depth = position.z;
#ifdef LIT
  vertex_direction = direction.xyz;
  vertex_position = vec3(position.xy, view_w(position.z));
#endif
#ifdef IMPORTANCE
  vertex_importance = interpolated_importance(importance);
#endif
#ifdef OPTIMIZED_VERTICES
  vertex_opacity = opacity;
#endif
}
