// SPDX-License-Identifier: GPL-3.0-or-later
// The depth test keeps the nearest depth of what is left.
#include "oit/shapes/fragment.glsl"
#include "oit/methods/peeling/peel_key.glsl"

void main() {
  Fragment f = fragment();
  if (!is_left(key_of(f))) discard;
  gl_FragDepth = f.depth;
}
