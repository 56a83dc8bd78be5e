// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a pixel from front to back.
#include "oit/gl/bindings.glsl"
#include "oit/stage/front_to_back.glsl"

layout(binding = layer_depths_image, r32ui) coherent uniform uimage2DArray depths;
// Premultiplied; transmittance.
layout(binding = layer_sums_image, rgba32f) coherent uniform image2DArray sums;

struct Layer {
  uint depth;  // bits of d, which compare as d does; all ones: no fragment yet
  Composite sum;
};

bool is_empty(Layer layer) { return layer.depth == ~0u; }

uint load_depth(ivec2 pixel, int i) { return imageLoad(depths, ivec3(pixel, i)).r; }

Layer load_layer(ivec2 pixel, int i) {
  vec4 texel = imageLoad(sums, ivec3(pixel, i));
  return Layer(load_depth(pixel, i), Composite(texel.rgb, texel.a));
}

void store_layer(ivec2 pixel, int i, Layer layer) {
  ivec3 place = ivec3(pixel, i);
  imageStore(depths, place, uvec4(layer.depth));
  imageStore(sums, place, vec4(layer.sum.color, layer.sum.transmittance));
}

Layer over(Layer front, Layer back) { return Layer(front.depth, over(front.sum, back.sum)); }
