// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of ribbons.
#include "oit/shapes/indexed_vertex.glsl"

void main() {
  hand_on_vertex();
#ifdef LIT
  vertex_across = direction.w;
#endif
}
