// SPDX-License-Identifier: GPL-3.0-or-later
// The pixels' trees in memory. Layer 0 stands for none.
#include "oit/gl/bindings.glsl"
#include "oit/lists/layer_tree.glsl"

layout(binding = trees_image, rg32ui) coherent uniform uimage2D trees;
// Left, right, bits of d, priority.
layout(binding = layers_image, rgba32ui) uniform uimageBuffer layers;
// Next; fragments, or a crossing's order.
layout(binding = layer_links_image, rg32ui) uniform uimageBuffer layer_links;
// Mean straight colour, mean opacity.
layout(binding = layer_colors_image, rgba32f) uniform imageBuffer layer_colors;
#ifdef AVERAGE_ATTRIBUTES
// Mean normal, view frame, not of unit length; colours are not lit then.
layout(binding = layer_normals_image, rgba32f) uniform imageBuffer layer_normals;
#endif

Tree load_tree(ivec2 pixel) {
  uvec2 texel = imageLoad(trees, pixel).rg;
  return Tree(texel.x, texel.y);
}
void store_tree(ivec2 pixel, Tree tree) {
  imageStore(trees, pixel, uvec4(tree.root, tree.first, 0u, 0u));
}

Layer load_layer(uint id) {
  uvec4 texel = imageLoad(layers, int(id));
  return Layer(texel.x, texel.y, uintBitsToFloat(texel.z), texel.w);
}
void store_layer(uint id, Layer layer) {
  imageStore(layers, int(id),
             uvec4(layer.left, layer.right, floatBitsToUint(layer.depth), layer.priority));
}

uint load_next(uint id) { return imageLoad(layer_links, int(id)).x; }
uint load_order(uint id) { return imageLoad(layer_links, int(id)).y; }
uint load_count(uint id) { return imageLoad(layer_links, int(id)).y; }
void store_next(uint id, uint next) {
  imageStore(layer_links, int(id), uvec4(next, load_count(id), 0u, 0u));
}
void store_count(uint id, uint count) {
  imageStore(layer_links, int(id), uvec4(load_next(id), count, 0u, 0u));
}
