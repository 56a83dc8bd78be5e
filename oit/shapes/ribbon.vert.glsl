// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of ribbons. The corners of a line's point have one even and one odd number.
#include "oit/shapes/view.glsl"

layout(location = 0) in vec3 position;  // see view.glsl
layout(location = 1) in vec4 color;     // straight colour, opacity

layout(location = 0) out vec4 vertex_color;
layout(location = 1) out float vertex_depth;
#ifdef LIT
layout(location = 2) in vec3 direction;  // of the line, view frame, unit length
layout(location = 2) out vec3 vertex_direction;
layout(location = 3) out vec3 vertex_position;  // view frame, the eye at 0
layout(location = 4) out float vertex_across;   // -1 … 1 from one rim to the other
#endif
#ifdef IMPORTANCE
layout(location = 3) in float importance;
layout(location = 5) out float vertex_importance;
#endif
#ifdef OPTIMIZED_VERTICES
layout(location = 4) in float opacity;
layout(location = 6) out float vertex_opacity;
#endif

void main() {
  gl_Position = clip_position(position);
  vertex_color = color;
  vertex_depth = position.z;
#ifdef LIT
  vertex_direction = direction;
  vertex_position = vec3(position.xy, view_w(position.z));
  vertex_across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
#endif
#ifdef IMPORTANCE
  vertex_importance = importance;
#endif
#ifdef OPTIMIZED_VERTICES
  vertex_opacity = opacity;
#endif
}
