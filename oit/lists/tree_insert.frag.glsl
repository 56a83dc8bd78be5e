// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the fragments of every pixel's list into its tree, and takes them out of the list; a pixel
// of many stops early and is counted, and so does one that finds no room for a new layer.
#include "oit/lists/fragment_list.glsl"
#include "oit/lists/layer_nodes.glsl"

layout(binding = layer_counter) uniform atomic_uint layer_count;
layout(binding = unfinished_storage) buffer Unfinished { uint unfinished, too_deep; };

uniform float epsilon2;
uniform bool crossings;   // the lists hold crossings of meshes
uniform bool first_met;
uniform int most_steps;
uniform uint capacity;  // layers that there is room for

#ifdef AVERAGE_ATTRIBUTES
#include "oit/lists/normal_bits.glsl"

void add_normal(uint id, uint bits, float count) {
  vec4 n = vec4(unpack_normal(bits), 0.0);
  vec4 mean = count > 1.0 ? imageLoad(layer_normals, int(id)) : n;
  // A surface has two sides, and no fragment knows which of them is the layer's.
  if (dot(mean, n) < 0.0) n = -n;
  imageStore(layer_normals, int(id), running_mean(mean, n, count));
}
#else
void add_normal(uint id, uint bits, float count) {}
#endif

void merge(uint id, float depth, vec4 color, uint normal) {
  uint count = load_count(id) + 1u;
  store_count(id, count);
  imageStore(layer_colors, int(id),
             running_mean(imageLoad(layer_colors, int(id)), color, float(count)));
  add_normal(id, normal, float(count));
  Layer layer = load_layer(id);
  layer.depth = running_mean(layer.depth, depth, float(count));
  store_layer(id, layer);
}

Tree add(Tree tree, Entry entry, Place place, uint id, vec4 color, uint normal) {
  tree = insert_layer(tree, entry, place, id);
  store_count(id, crossings ? entry.order : 1u);
  imageStore(layer_colors, int(id), color);
  add_normal(id, normal, 1.0);
  return tree;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint fragment = imageLoad(heads, pixel).r;
  if (fragment == 0u) discard;
  Tree tree = load_tree(pixel);
  for (int steps = 0; fragment != 0u && steps < most_steps;) {
    uvec4 texel = imageLoad(nodes, int(fragment));
    vec4 color = imageLoad(colors, int(fragment));
    Entry entry = Entry(uintBitsToFloat(texel.y), crossings, crossings ? texel.z : 0u);
    Place place = find_place(tree, entry, epsilon2, first_met);
    if (place.too_deep) {
      atomicAdd(too_deep, 1u);
      break;
    }
    if (place.nearest != 0u)
      merge(place.nearest, entry.depth, color, texel.w);
    else {
      uint id = atomicCounterIncrement(layer_count) + 1u;
      if (id > capacity) break;  // it stays in the list
      tree = add(tree, entry, place, id, color, texel.w);
    }
    fragment = texel.x;
    // The search, as many steps at most to split, and this.
    steps += 2 * place.steps + 1;
  }
  store_tree(pixel, tree);
  imageStore(heads, pixel, uvec4(fragment));
  if (fragment != 0u) atomicAdd(unfinished, 1u);
}
