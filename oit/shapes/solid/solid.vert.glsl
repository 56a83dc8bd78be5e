// SPDX-License-Identifier: GPL-3.0-or-later
// A solid as a rectangle of the picture around it, twice: for where rays enter and for where they
// leave. Solids are fetched, so that each is stored once.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"
#include "oit/shapes/solid/solid_record.glsl"

uniform uint first_record, stride_of_records;

void main() {
  const int corners[6] = int[](0, 1, 2, 2, 1, 3);
  vertex_record = int(first_record) + gl_VertexID / 12 * int(stride_of_records);
  vec4 bounds = uintBitsToFloat(texelFetch(solids, SOLID_TEXELS * vertex_record));
  vec2 axis = uintBitsToFloat(texelFetch(solids, SOLID_TEXELS * vertex_record + 1).xy);
  int corner = corners[gl_VertexID % 6];
  vec2 p = vec2(corner % 2 == 0 ? bounds.x : bounds.y, corner < 2 ? bounds.z : bounds.w);
  vec2 position = vec2(axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y);
  gl_Position = vec4(position * clip_scale + clip_shift, 0.0, 1.0);
}
