// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/lists/list_append.glsl"

void main() {
  Fragment f = fragment();
  append_fragment(f, vec4(f.color, f.alpha));
}
