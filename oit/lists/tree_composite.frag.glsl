// SPDX-License-Identifier: GPL-3.0-or-later
// Composites every pixel's layers from front to back: Algorithm 2 of Tian and Guenther, whose stack the
// links of the layers replace. A pixel of so many that llvmpipe ends its
// loop (after 65535 iterations, without an error) is counted.
#include "oit/stage/composite.glsl"
#include "oit/lists/layer_nodes.glsl"

layout(binding = unfinished_storage) buffer Unfinished { uint unfinished; };

#define REPEAT8(X) X X X X X X X X

#ifdef AVERAGE_ATTRIBUTES
#include "oit/shapes/lighting.glsl"
#include "oit/shapes/pixel_ray.glsl"

// Lit by the mean normal, as published.
vec4 layer_color(uint id, vec3 ray) {
  vec4 color = imageLoad(layer_colors, int(id));
  vec3 n = imageLoad(layer_normals, int(id)).xyz;
  float size = length(n);
  return vec4(lit(color.rgb, size > 0.0 ? abs(dot(n, ray)) / size : 0.0), color.a);
}
#else
vec4 layer_color(uint id, vec3 ray) { return imageLoad(layer_colors, int(id)); }
#endif

void main() {
  Composite c = nothing;
#ifdef AVERAGE_ATTRIBUTES
  vec3 ray = pixel_ray(imageSize(trees));
#else
  vec3 ray = vec3(0.0);
#endif
  uint id = load_tree(ivec2(gl_FragCoord.xy)).first;
  while (id != 0u) {
    REPEAT8(if (id != 0u) {
      add_layer(c, layer_color(id, ray));
      id = load_next(id);
    })
  }
  if (id != 0u) atomicAdd(unfinished, 1u);
  picture = over(c, behind());
}
