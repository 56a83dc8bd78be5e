// SPDX-License-Identifier: GPL-3.0-or-later
// The light at the eye: what scene/appearance/lighting.h says, c = |n . v|.
vec3 lit(vec3 color, float c) {
#ifdef PHONG
  const float ambient = 0.15, highlight = 0.35, exponent = 24.0;
  float shine = highlight * pow(max(0.0, 2.0 * c * c - 1.0), exponent);
  return min(color * (ambient + (1.0 - ambient) * c) + shine, 1.0);
#else
  return color * c;
#endif
}
