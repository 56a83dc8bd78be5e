// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a pixel from front to back.
layout(binding = 0, r32ui) coherent uniform uimage2DArray depths;
layout(binding = 1, rgba32f) coherent uniform image2DArray colors;

struct Layer {
  uint depth;  // bits of d, which compare as d does; all ones: no fragment yet
  vec4 color;  // premultiplied; transmittance
};

bool is_empty(Layer layer) { return layer.depth == ~0u; }

uint load_depth(ivec2 pixel, int i) { return imageLoad(depths, ivec3(pixel, i)).r; }

Layer load_layer(ivec2 pixel, int i) {
  return Layer(load_depth(pixel, i), imageLoad(colors, ivec3(pixel, i)));
}

void store_layer(ivec2 pixel, int i, Layer layer) {
  ivec3 place = ivec3(pixel, i);
  imageStore(depths, place, uvec4(layer.depth));
  imageStore(colors, place, layer.color);
}

Layer over(Layer front, Layer back) {
  return Layer(front.depth, vec4(front.color.rgb + front.color.a * back.color.rgb,
                                 front.color.a * back.color.a));
}
