// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts and consumes every pixel whose layers fit into registers and empties its list; counts the
// layers of the others, which are left to the passes that follow. What these do is kept out of this
// shader: on llvmpipe a branch costs its time whether it is taken or not.
#include "oit/lists/list_consumer.glsl"

layout(binding = longest_storage) buffer Longest { uint longest; };

void consume_run(uint list) {
  Consumer c = start(list);
  for (Node node = take_from_run(); node.id != 0u; node = take_from_run()) consume(c, node.id);
  finish(c);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint list = imageLoad(heads, pixel).r;
  uint rest = list;
  fill_run(rest);
  if (rest != 0u) {
    atomicMax(longest, uint(count(list)));
    discard;
  }
  consume_run(list);
  imageStore(heads, pixel, uvec4(0u));
}
