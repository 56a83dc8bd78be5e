// SPDX-License-Identifier: GPL-3.0-or-later
// Building the lists. After fragment.glsl.
#include "oit/lists/fragment_list.glsl"

layout(binding = node_counter) uniform atomic_uint node_count;

// `content`: straight colour and opacity, or what list_consumer.glsl finds in their place.
void append_fragment(Fragment f, vec4 content) {
  int node = int(atomicCounterIncrement(node_count)) + 1;
  uint next = imageAtomicExchange(heads, ivec2(gl_FragCoord.xy), uint(node));
#ifdef IMPORTANCE
  uint importance_bits = floatBitsToUint(importance());
#else
  uint importance_bits = 0u;
#endif
  imageStore(nodes, node,
             uvec4(next, floatBitsToUint(f.depth), primitive_order(), importance_bits));
  imageStore(colors, node, content);
}
