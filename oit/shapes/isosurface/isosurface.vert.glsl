// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of an isosurface as a rectangle of the picture around it, once for every crossing that a
// ray may have in it.
#define VARYING out
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#include "oit/shapes/view.glsl"
#include "oit/shapes/rectangle.glsl"
#include "oit/shapes/isosurface/piece_record.glsl"

void main() {
  vertex_record = record_of_vertex(1);
  vec4 bounds = uintBitsToFloat(texelFetch(isosurface_pieces, PIECE_TEXELS * vertex_record));
  gl_Position = clip_position_of(corner_of_vertex(bounds));
}
