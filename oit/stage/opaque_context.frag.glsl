// SPDX-License-Identifier: GPL-3.0-or-later
// The depth test keeps the nearest, of equal depths the first.
#include "oit/shapes/fragment.glsl"

layout(location = 0) out vec4 picture;
layout(location = 1) out uvec2 key;

void main() {
  Fragment f = fragment();
  picture = vec4(f.color, 1.0);
  key = key_of(f);
  gl_FragDepth = f.depth;
}
