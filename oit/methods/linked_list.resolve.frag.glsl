// Sorts and composites every pixel of at most `most_layers` layers and empties its list; counts the
// layers of the others, which the passes of linked_list.merge and linked_list.blend see to.
#include "composite.glsl"
#include "front_to_back.glsl"
#include "list_sort.glsl"

layout(binding = 0) buffer Longest { uint longest; };
uniform int most_layers;

vec4 composite_run() {
  Composite c = nothing;
  for (Node node = take_from_run(); node.id != 0u; node = take_from_run())
    add_layer(c, imageLoad(colors, int(node.id)));
  return over(c, background);
}

vec4 composite_list(uint list) {
  Composite c = nothing;
  for (; list != 0u; list = load_node(list).next) add_layer(c, imageLoad(colors, int(list)));
  return over(c, background);
}

int count(uint list) {
  int n = 0;
  while (list != 0u) {
    REPEAT8(if (list != 0u) { list = load_node(list).next; ++n; })
  }
  return n;
}

// The run holds the first nodes of the list, `rest` is what follows them; `n` nodes in all.
uint sort_list(uint rest, int n) {
  Chain chain = empty_chain;
  append_run(chain);
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
  uint rest = list;
  fill_run(rest);
  if (rest == 0u) {
    picture = composite_run();
  } else {
    int n = count(list);
    if (n > most_layers) {
      atomicMax(longest, uint(n));
      discard;
    }
    picture = composite_list(sort_list(rest, n));
  }
  imageStore(heads, pixel, uvec4(0u));
}
