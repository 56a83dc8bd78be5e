// SPDX-License-Identifier: GPL-3.0-or-later
// The light at the eye: what scene/appearance/lighting.h says, c = |n . v|.
vec3 lit_by_phong(vec3 color, float c) {
  const float ambient = 0.15, highlight = 0.35, exponent = 24.0;
  float shine = highlight * pow(max(0.0, 2.0 * c * c - 1.0), exponent);
  return min(color * (ambient + (1.0 - ambient) * c) + shine, 1.0);
}

#ifdef LIT_BY_OBJECT
uniform int lighting;  // scene::Lighting of the objects that are being drawn

vec3 lit(vec3 color, float c) {
  if (lighting == 0) return color;
  return lighting == 1 ? color * c : lit_by_phong(color, c);
}
#elif defined(PHONG)
vec3 lit(vec3 color, float c) { return lit_by_phong(color, c); }
#else
vec3 lit(vec3 color, float c) { return color * c; }
#endif
