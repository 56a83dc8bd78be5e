// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of isosurfaces in a buffer: see isosurfaces.h. A texel is four words; a double is two.
#include "oit/gl/bindings.glsl"

// Five texels each: bounds in the picture; first corner, then last corner of its box, in world axes
// from the eye; where its numbers and those of its surface are, its degree and, from bit 8 on, one more
// than the axis across which it is a face; flags.
layout(binding = isosurface_pieces_texture) uniform usamplerBuffer isosurface_pieces;
const int PIECE_TEXELS = 5;
const uint PIECE_WEIGHTED = 1u;  // flag: Σ w is not 1; the bits above say which crossing this is
