// SPDX-License-Identifier: GPL-3.0-or-later
// One node of a list and one blended value: see driver_check.cpp.
#include "oit/gl/bindings.glsl"

layout(binding = checked_counter) uniform atomic_uint count;
layout(binding = checked_head_image, r32ui) coherent uniform uimage2D head;
layout(binding = checked_stores_image, rgba32ui) uniform uimageBuffer stores;

layout(location = 0) out vec4 color;

void main() {
  uint node = atomicCounterIncrement(count) + 1u;
  uint previous = imageAtomicExchange(head, ivec2(0), node);
  imageStore(stores, int(node), uvec4(previous, 7u, 0u, 0u));
  color = vec4(1e-5, 0.0, 0.0, 1e5);
}
