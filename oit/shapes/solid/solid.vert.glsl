// SPDX-License-Identifier: GPL-3.0-or-later
// A solid as a rectangle of the picture around it, twice: for where rays enter and for where they
// leave. Solids are fetched, so that each is stored once.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"
#include "oit/shapes/rectangle.glsl"
#include "oit/shapes/solid/solid_record.glsl"

void main() {
  vertex_record = record_of_vertex(2);
  vec4 bounds = uintBitsToFloat(texelFetch(solids, SOLID_TEXELS * vertex_record));
  vec2 axis = uintBitsToFloat(texelFetch(solids, SOLID_TEXELS * vertex_record + 1).xy);
  vec2 p = corner_of_vertex(bounds);
  gl_Position = clip_position_of(vec2(axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y));
}
