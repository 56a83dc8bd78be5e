// SPDX-License-Identifier: GPL-3.0-or-later
// Counts every pixel's layers, and those that lie nearer than the layer in front of them.
#include "oit/lists/layer_nodes.glsl"

layout(location = 0) out vec2 counts;

#define REPEAT8(X) X X X X X X X X

void main() {
  counts = vec2(0.0);
  float depth = 0.0;
  uint id = load_tree(ivec2(gl_FragCoord.xy)).first;
  while (id != 0u) {
    REPEAT8(if (id != 0u) {
      float here = load_layer(id).depth;
      counts += vec2(1.0, here < depth);
      depth = here;
      id = load_next(id);
    })
  }
}
