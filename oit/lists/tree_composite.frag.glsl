// SPDX-License-Identifier: GPL-3.0-or-later
// Composites every pixel's layers from front to back: Algorithm 2 of Tian and Guenther, whose stack the
// links of the layers replace. A pixel of so many that llvmpipe ends its
// loop (after 65535 iterations, without an error) is counted.
#include "oit/stage/composite.glsl"
#include "oit/lists/layer_nodes.glsl"

layout(binding = unfinished_storage) buffer Unfinished { uint unfinished; };

#define REPEAT8(X) X X X X X X X X

void main() {
  Composite c = nothing;
  uint id = load_tree(ivec2(gl_FragCoord.xy)).first;
  while (id != 0u) {
    REPEAT8(if (id != 0u) {
      add_layer(c, imageLoad(layer_colors, int(id)));
      id = load_next(id);
    })
  }
  if (id != 0u) atomicAdd(unfinished, 1u);
  picture = over(c, behind());
}
