// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts the fragment among the pixel's layers; the one too many is merged into the last.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/mlab/alpha_layers.glsl"
#include "oit/stage/pixel_lock.glsl"

void insert(ivec2 pixel, Layer layer) {
  int i = 0;
  while (i < LAYERS && load_depth(pixel, i) <= layer.depth) ++i;
  for (; i < LAYERS && !is_empty(layer); ++i) {
    Layer farther = load_layer(pixel, i);
    store_layer(pixel, i, layer);
    layer = farther;
  }
  if (is_empty(layer)) return;
  store_layer(pixel, LAYERS - 1, over(load_layer(pixel, LAYERS - 1), layer));
}

void main() {
  Fragment f = fragment();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Layer layer = Layer(floatBitsToUint(f.depth), Composite(f.alpha * f.color, 1.0 - f.alpha));
  ONE_AT_A_TIME(pixel, insert(pixel, layer))
}
