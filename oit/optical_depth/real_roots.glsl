// SPDX-License-Identifier: GPL-3.0-or-later
// Roots of polynomials all of whose roots are real, for GLSL and, through GLM, for C++. The roots of
// the derivative lie between them: Laguerre's method goes from those to either side, and while all
// roots are real no step of it passes one. No angles: they lose the near roots' digits to a far one.
#ifndef REAL_ROOTS
#define REAL_ROOTS
#include "oit/optical_depth/orthogonal_polynomials.glsl"

// Of k2 t^2 + k1 t + k0, the larger one first.
vec2 quadratic_roots(float k2, float k1, float k0) {
  float q = -0.5f * (k1 + (k1 < 0.0f ? -1.0f : 1.0f) * sqrt(max(k1 * k1 - 4.0f * k2 * k0, 0.0f)));
  float a = q / k2, b = k0 / q;
  return vec2(max(a, b), min(a, b));
}

// From t to roots of c, of degree n, on the sides that the signs of `side` say. The sign of the value
// would say it, too, but rounding turns that where a root is found. Where the square is negative, two
// roots are one but for rounding.
vec4 laguerre(Vector5 c, float n, vec4 t, vec4 side) {
  for (int i = 0; i < 8; ++i) {  // with 6, one of a thousand pairs of close roots is not yet apart
    vec4 value = (((c.v[4] * t + c.v[3]) * t + c.v[2]) * t + c.v[1]) * t + c.v[0];
    vec4 slope = ((4.0f * c.v[4] * t + 3.0f * c.v[3]) * t + 2.0f * c.v[2]) * t + c.v[1];
    vec4 bend = (12.0f * c.v[4] * t + 6.0f * c.v[3]) * t + 2.0f * c.v[2];
    vec4 square = (n - 1.0f) * ((n - 1.0f) * slope * slope - n * value * bend);
    vec4 divisor = slope + side * sqrt(max(square, vec4(0.0f)));
    t += mix(-n * value / divisor, vec4(0.0f), lessThanEqual(square, vec4(0.0f)));
  }
  return t;
}

// Of a polynomial of degree 3, from the largest on; the fourth is the third again. The middle one is
// looked for from the nearer turn: the way from that of a far root is long.
vec4 cubic_roots(Vector5 c) {
  vec2 turns = quadratic_roots(3.0f * c.v[3], 2.0f * c.v[2], c.v[1]);
  float rising = c.v[3] < 0.0f ? -1.0f : 1.0f;
  float nearer = abs(turns.x) < abs(turns.y) ? turns.x : turns.y;
  return laguerre(c, 3.0f, vec4(turns.x, nearer, turns.y, turns.y),
                  rising * vec4(1.0f, -1.0f, 1.0f, 1.0f));
}

// Of a polynomial of degree 4, from the largest on.
vec4 quartic_roots(Vector5 c) {
  Vector5 derivative;
  derivative.v[0] = c.v[1];
  derivative.v[1] = 2.0f * c.v[2];
  derivative.v[2] = 3.0f * c.v[3];
  derivative.v[3] = 4.0f * c.v[4];
  derivative.v[4] = 0.0f;
  vec4 turns = cubic_roots(derivative);
  float rising = c.v[4] < 0.0f ? -1.0f : 1.0f;
  return laguerre(c, 4.0f, vec4(turns.x, turns.y, turns.y, turns.z),
                  rising * vec4(1.0f, -1.0f, 1.0f, -1.0f));
}

float held_lead(float lead) { return abs(lead) < 1e-7f ? (lead < 0.0f ? -1e-7f : 1e-7f) : lead; }

// Of degree 3 or 4: the largest coefficient becomes 1, so that no square overflows. A leading one of 0
// would be a root at infinity; it is held away.
Vector5 scaled(Vector5 c, int n) {
  float scale = max(max(abs(c.v[0]), abs(c.v[1])), max(abs(c.v[2]), abs(c.v[3])));
  scale = max(n == 4 ? max(scale, abs(c.v[4])) : scale, 1e-30f);
  c.v[0] /= scale;
  c.v[1] /= scale;
  c.v[2] /= scale;
  c.v[3] = n == 3 ? held_lead(c.v[3] / scale) : c.v[3] / scale;
  c.v[4] = n == 4 ? held_lead(c.v[4] / scale) : 0.0f;
  return c;
}

// Of the polynomial with the coefficients c, of degree n: the first n. One that is far from the others
// is held where infinity cannot make a NaN of it.
vec4 real_roots(Vector5 c, int n) {
  vec4 roots;
  if (n == 2) {
    roots = vec4(quadratic_roots(c.v[2], c.v[1], c.v[0]), 0.0f, 0.0f);
  } else {
    c = scaled(c, n);
    roots = n == 3 ? cubic_roots(c) : quartic_roots(c);
  }
  return clamp(roots, vec4(-1e3f), vec4(1e3f));
}
#endif
