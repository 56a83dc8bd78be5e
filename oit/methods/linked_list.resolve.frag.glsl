// Sorts and composites every pixel whose layers fit into registers and empties its list; counts the
// layers of the others, which are left to the passes that follow. What these do is kept out of this
// shader: on llvmpipe a branch costs its time whether it is taken or not.
#include "composite.glsl"
#include "front_to_back.glsl"
#include "list_sort.glsl"

layout(binding = 0) buffer Longest { uint longest; };

vec4 composite_run() {
  Composite c = nothing;
  for (Node node = take_from_run(); node.id != 0u; node = take_from_run())
    add_layer(c, imageLoad(colors, int(node.id)));
  return over(c, behind());
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
  picture = composite_run();
  imageStore(heads, pixel, uvec4(0u));
}
