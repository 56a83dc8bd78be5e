// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of an isosurface as a rectangle of the picture around it, once for every crossing that a
// ray may have in it.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"
#include "oit/shapes/isosurface/piece_record.glsl"

uniform uint first_record, stride_of_records;

void main() {
  const int corners[6] = int[](0, 1, 2, 2, 1, 3);
  vertex_record = int(first_record) + gl_VertexID / 6 * int(stride_of_records);
  vec4 bounds = uintBitsToFloat(texelFetch(isosurface_pieces, PIECE_TEXELS * vertex_record));
  int corner = corners[gl_VertexID % 6];
  vec2 position = vec2(corner % 2 == 0 ? bounds.x : bounds.y, corner < 2 ? bounds.z : bounds.w);
  gl_Position = vec4(position * clip_scale + clip_shift, 0.0, 1.0);
}
