// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of meshes.
#include "oit/shapes/indexed_vertex.glsl"

void main() { hand_on_vertex(); }
