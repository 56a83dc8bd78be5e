// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/stage/composite.glsl"
#include "oit/methods/mlab/alpha_layers.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Composite sum = nothing;
  for (int i = 0; i < LAYERS; ++i) {
    Layer layer = load_layer(pixel, i);
    if (is_empty(layer)) break;
    sum = over(sum, layer.sum);
  }
  picture = over(sum, behind());
}
