// SPDX-License-Identifier: GPL-3.0-or-later
// Solids in a buffer: see solids.cpp. A texel is four words; a double is two.
#include "oit/gl/bindings.glsl"

// Three texels each: bounds in the picture; their first axis, radius at the first point; first point,
// first of what overlaps it, how many do, and where among these the radius at its second point is,
// with the define TAPERED.
layout(binding = solids_texture) uniform usamplerBuffer solids;
const int SOLID_TEXELS = 3;
