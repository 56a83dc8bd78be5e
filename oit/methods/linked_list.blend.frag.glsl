// Composites the sorted lists that are left.
#include "composite.glsl"
#include "front_to_back.glsl"
#include "list_sort.glsl"

void main() {
  uint list = imageLoad(heads, ivec2(gl_FragCoord.xy)).r;
  if (list == 0u) discard;
  Composite c = nothing;
  while (list != 0u) {
    REPEAT8(if (list != 0u) {
      add_layer(c, imageLoad(colors, int(list)));
      list = load_node(list).next;
    })
  }
  picture = over(c, behind());
}
