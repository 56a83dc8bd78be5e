// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"

uniform float strength;

layout(location = 0) out vec4 absorbed;  // blended into the product of 1 - absorbed

void main() {
  Fragment f = fragment();
  absorbed = f.alpha * vec4(strength * (1.0 - f.color), 1.0);
}
