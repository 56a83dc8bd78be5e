// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest depths of a pixel in ascending order, as bits of d; all ones: no fragment yet. A
// place whose colour is there has bit 31 set, which no d >= 0 has.
#include "oit/gl/bindings.glsl"

layout(binding = k_depths_image, r32ui) coherent uniform uimage2DArray depths;
layout(binding = k_colors_image, rgba32f) uniform image2DArray colors;

const uint EMPTY = ~0u;
const uint CLAIMED = 0x80000000u;
