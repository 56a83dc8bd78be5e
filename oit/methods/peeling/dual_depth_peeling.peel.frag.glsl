// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the nearest and the farthest fragment of what is left; with the define COUNT_LEFT, passes all
// that are left.
#include "oit/shapes/fragment.glsl"
#include "oit/stage/pixel_lock.glsl"

// Keys of the nearest fragment found, as its complement, and of the farthest one; and those of the
// last ones peeled, the farthest as its complement. So 0 stands for nothing found and for nothing
// peeled, and after a peel left = ~ends.
layout(binding = ends_image, rgba32ui) coherent uniform uimage2D ends;
layout(binding = left_keys_texture) uniform usampler2D left;
layout(binding = nearest_layer_image, rgba32f) coherent uniform image2D nearest_layer;
layout(binding = farthest_layer_image, rgba32f) coherent uniform image2D farthest_layer;

bool is_nearer(uvec2 key, uvec4 found) { return precedes(found.xy, ~key); }
bool is_farther(uvec2 key, uvec4 found) { return precedes(found.zw, key); }

bool is_left(uvec2 key) {
  uvec4 peeled = texelFetch(left, ivec2(gl_FragCoord.xy), 0);
  return precedes(peeled.xy, key) && precedes(peeled.zw, ~key);
}

void keep(ivec2 pixel, uvec2 key, vec4 layer) {
  uvec4 found = imageLoad(ends, pixel);
  if (is_nearer(key, found)) {
    found.xy = ~key;
    imageStore(nearest_layer, pixel, layer);
  }
  if (is_farther(key, found)) {
    found.zw = key;
    imageStore(farthest_layer, pixel, layer);
  }
  imageStore(ends, pixel, found);
}

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 key = key_of(f);
  if (!is_left(key)) discard;
#ifndef COUNT_LEFT
  // The ends only part: what lies between them now will not be one, and needs no lock.
  uvec4 found = imageLoad(ends, pixel);
  if (!is_nearer(key, found) && !is_farther(key, found)) discard;
  ONE_AT_A_TIME(pixel, keep(pixel, key, vec4(f.color, f.alpha)))
#endif
}
