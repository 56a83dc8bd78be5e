// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts and consumes the lists that are left, of at most `most_layers` layers, and empties them.
#include "oit/lists/list_consumer.glsl"

uniform int most_layers;

void consume_list(uint list) {
  Consumer c = start(list);
  for (uint node = list; node != 0u; node = load_node(node).next) consume(c, node);
  finish(c);
}

// `n` nodes in all.
uint sort_list(uint rest, int n) {
  Chain chain = empty_chain;
  while (rest != 0u) {
    fill_run(rest);
    append_run(chain);
  }
  link(chain.last, 0u);
  uint list = chain.first;
  for (int length = RUN; length < n; length *= 2) list = merge_runs(list, length);
  return list;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint list = imageLoad(heads, pixel).r;
  int n = count(list);
  if (n == 0 || n > most_layers) discard;
  consume_list(sort_list(list, n));
  imageStore(heads, pixel, uvec4(0u));
}
