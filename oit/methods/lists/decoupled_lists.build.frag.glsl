// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/fragment.glsl"
#include "oit/shapes/element.glsl"
#include "oit/lists/list_append.glsl"

void main() {
  Fragment f = fragment();
  int e = element();
  if (e < 0) discard;
  // A float holds 24 bits of the element's number.
  append_fragment(f, vec4(e / 65536, e % 65536, 0.0, 0.0));
}
