// SPDX-License-Identifier: GPL-3.0-or-later
// Fragments are peeled in the order of compositing.
#include "oit/gl/bindings.glsl"

layout(binding = peeled_keys_texture) uniform usampler2D peeled;  // key of the last peeled fragment

bool is_left(uvec2 key) {
  return precedes(texelFetch(peeled, ivec2(gl_FragCoord.xy), 0).xy, key);
}
