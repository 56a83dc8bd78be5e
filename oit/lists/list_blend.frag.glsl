// SPDX-License-Identifier: GPL-3.0-or-later
// Consumes the sorted lists that are left.
#include "oit/lists/list_consumer.glsl"

void main() {
  uint list = imageLoad(heads, ivec2(gl_FragCoord.xy)).r;
  if (list == 0u) discard;
  Consumer c = start(list);
  while (list != 0u) {
    REPEAT8(if (list != 0u) {
      consume(c, list);
      list = load_node(list).next;
    })
  }
  finish(c);
}
