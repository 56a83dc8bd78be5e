// Sorts and composites the lists that are left, of at most `most_layers` layers, and empties them.
#include "composite.glsl"
#include "front_to_back.glsl"
#include "list_sort.glsl"

uniform int most_layers;

vec4 composite_list(uint list) {
  Composite c = nothing;
  for (; list != 0u; list = load_node(list).next) add_layer(c, imageLoad(colors, int(list)));
  return over(c, behind());
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
  picture = composite_list(sort_list(list, n));
  imageStore(heads, pixel, uvec4(0u));
}
