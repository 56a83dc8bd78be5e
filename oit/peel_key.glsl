// The order in which fragments are peeled: by depth, then by submission. 0 precedes all of them.
layout(binding = 0) uniform usampler2D peeled;  // key of the last peeled fragment

uvec2 key_of(Fragment f) { return uvec2(floatBitsToUint(f.depth), uint(gl_PrimitiveID) + 1u); }

bool is_left(uvec2 key) {
  uvec2 last = texelFetch(peeled, ivec2(gl_FragCoord.xy), 0).xy;
  return key.x > last.x || (key.x == last.x && key.y > last.y);
}
