// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of the per-pixel lists. Node 0 stands for the end of a list.
#include "oit/gl/bindings.glsl"

layout(binding = heads_image, r32ui) coherent uniform uimage2D heads;
// Next, bits of d, order of submission, bits of the importance or of the normal where a program lists one.
layout(binding = nodes_image, rgba32ui) uniform uimageBuffer nodes;
layout(binding = node_colors_image, rgba32f) uniform imageBuffer colors;  // straight colour, opacity
