// The depth test keeps the nearest depth of what is left.
#include "fragment.glsl"
#include "peel_key.glsl"

void main() {
  Fragment f = fragment();
  if (!is_left(key_of(f))) discard;
  gl_FragDepth = f.depth;
}
