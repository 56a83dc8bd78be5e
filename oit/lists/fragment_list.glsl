// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of the per-pixel lists. Node 0 stands for the end of a list.
layout(binding = 0, r32ui) coherent uniform uimage2D heads;
layout(binding = 1, rgba32ui) uniform uimageBuffer nodes;  // next, bits of d, order of submission
layout(binding = 2, rgba32f) uniform imageBuffer colors;   // straight colour, opacity
