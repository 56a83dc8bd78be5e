// SPDX-License-Identifier: GPL-3.0-or-later
// A unit vector in 32 bits, within 5e-5: on an octahedron, unfolded into a square (Cigolle et al.
// 2014, "A survey of efficient representations for independent unit vectors", JCGT 3(2)).
vec2 away_from_zero(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }

uint pack_normal(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  return packSnorm2x16(n.z < 0.0 ? (1.0 - abs(n.yx)) * away_from_zero(n.xy) : n.xy);
}

vec3 unpack_normal(uint bits) {
  vec2 square = unpackSnorm2x16(bits);
  vec3 n = vec3(square, 1.0 - abs(square.x) - abs(square.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * away_from_zero(n.xy);
  return normalize(n);
}
