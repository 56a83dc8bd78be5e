// SPDX-License-Identifier: GPL-3.0-or-later
// Building the lists. After fragment.glsl.
#include "oit/lists/fragment_list.glsl"
#ifdef IMPORTANCE
#include "oit/opacity/importance_bits.glsl"
#endif
#ifdef LIT_LATER
#include "oit/lists/normal_bits.glsl"
#include "oit/shapes/pixel_ray.glsl"
#endif

layout(binding = node_counter) uniform atomic_uint node_count;

// `content`: straight colour and opacity, or what list_consumer.glsl finds in their place.
void append_fragment(Fragment f, vec4 content) {
  int node = int(atomicCounterIncrement(node_count)) + 1;
  uint next = imageAtomicExchange(heads, ivec2(gl_FragCoord.xy), uint(node));
#if defined(IMPORTANCE)
  uint more = pack_importance(importance());
#elif defined(LIT_LATER)
  uint more = pack_normal(shading_normal(pixel_ray(imageSize(heads))));
#else
  uint more = 0u;
#endif
  imageStore(nodes, node,
             uvec4(next, floatBitsToUint(f.depth), primitive_order(), more));
  imageStore(colors, node, content);
}
