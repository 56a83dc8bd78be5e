// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of ribbons. The corners of a line's point have one even and one odd number.
#include "oit/shapes/indexed_vertex.glsl"

void main() {
  hand_on_vertex();
#ifdef LIT
  vertex_across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
#endif
}
