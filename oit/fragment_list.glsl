// The nodes of the per-pixel lists. Node 0 stands for the end of a list.
layout(binding = 0, r32ui) coherent uniform uimage2D heads;
layout(binding = 1, r32ui) uniform uimageBuffer nexts;
layout(binding = 2, rg32ui) uniform uimageBuffer keys;    // bits of depth d >= 0; order of submission
layout(binding = 3, rgba32f) uniform imageBuffer colors;  // straight colour, opacity
