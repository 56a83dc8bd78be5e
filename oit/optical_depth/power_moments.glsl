// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth in front of a depth from power moments, for GLSL and, through GLM, for C++:
// Muenstermann, Krumpen, Klein and Peters 2018.
//
// Of all distributions on the line with the given moments, the canonical one with mass at z holds
// most mass at z. Its other points are the roots in t of the kernel K(t, z) = sum p_k(t) p_k(z)/d_k
// of the orthogonal polynomials, and a point t has the mass 1 / K(t, t). What lies in front of z is
// the mass of the points before it, and of z itself the share `overestimation`.
#include "oit/optical_depth/real_roots.glsl"

// The orthogonal polynomials by their recurrence,
//   p_k+1(t) = (t - a_k) p_k(t) - b_k p_k-1(t),   p_0 = 1,   d_k = b_1 ... b_k,
// which 2 n moments are enough for, and which is all that a pixel has to keep of them.
struct Recurrence {
  vec4 a;  // a_0 ... a_3
  vec4 b;  // b_1 ... b_4
};

// Of the `moments` 0 to 2 n of a distribution of mass 1 on [-1, 1], n = 2, 3, 4. What t^k has of
// p_k-1 is the sum of a_0 ... a_k-1.
Recurrence recurrence_of(float moments[9], int n) {
  Polynomials p = orthogonal_polynomials(moments, n);
  Recurrence r;
  r.a = vec4(p.l1[0], p.l2[1] - p.l1[0], 0.0f, 0.0f);
  r.b = vec4(p.d[1] / p.d[0], p.d[2] / p.d[1], 0.0f, 0.0f);
  if (n >= 3) {
    r.a.z = p.l3[2] - p.l2[1];
    r.b.z = p.d[3] / p.d[2];
  }
  if (n >= 4) {
    r.a.w = p.l4[3] - p.l3[2];
    r.b.w = p.d[4] / p.d[3];
  }
  return r;
}

// p_1(t) ... p_4(t).
vec4 values_at(Recurrence r, float t) {
  vec4 p;
  p.x = t - r.a.x;
  p.y = (t - r.a.y) * p.x - r.b.x;
  p.z = (t - r.a.z) * p.y - r.b.y * p.x;
  p.w = (t - r.a.w) * p.z - r.b.z * p.y;
  return p;
}

// 1 / d_1 ... 1 / d_n, then 0.
vec4 inverse_norms(Recurrence r, int n) {
  float d1 = r.b.x, d2 = d1 * r.b.y;
  vec4 inverse = vec4(1.0f / d1, 1.0f / d2, 0.0f, 0.0f);
  if (n >= 3) inverse.z = 1.0f / (d2 * r.b.z);
  if (n >= 4) inverse.w = 1.0f / (d2 * r.b.z * r.b.w);
  return inverse;
}

// K(t, t), of the values of the polynomials at t.
float kernel_of(vec4 p, vec4 inverse, int n) {
  float sum = 1.0f + p.x * p.x * inverse.x + p.y * p.y * inverse.y;
  if (n >= 3) sum += p.z * p.z * inverse.z;
  if (n >= 4) sum += p.w * p.w * inverse.w;
  return sum;
}

// The coefficients of 1 + sum e_k p_k, k >= 1, in powers of t.
Vector5 in_powers(Recurrence r, int n, vec4 e) {
  vec2 p1 = vec2(-r.a.x, 1.0f);
  vec3 p2 = vec3(r.a.x * r.a.y - r.b.x, -r.a.x - r.a.y, 1.0f);
  Vector5 c;
  c.v[0] = 1.0f + e.x * p1.x + e.y * p2.x;
  c.v[1] = e.x + e.y * p2.y;
  c.v[2] = e.y;
  c.v[3] = c.v[4] = 0.0f;
  if (n < 3) return c;
  vec3 p3 = vec3(-r.a.z * p2.x - r.b.y * p1.x, p2.x - r.a.z * p2.y - r.b.y, p2.y - r.a.z);
  c.v[0] += e.z * p3.x;
  c.v[1] += e.z * p3.y;
  c.v[2] += e.z * p3.z;
  c.v[3] = e.z;
  if (n < 4) return c;
  c.v[0] += e.w * (-r.a.w * p3.x - r.b.z * p2.x);
  c.v[1] += e.w * (p3.x - r.a.w * p3.y - r.b.z * p2.y);
  c.v[2] += e.w * (p3.y - r.a.w * p3.z - r.b.z);
  c.v[3] += e.w * (p3.z - r.a.w);
  c.v[4] = e.w;
  return c;
}

float mass_before(Recurrence r, vec4 inverse, int n, float t, float z) {
  return t < z ? 1.0f / kernel_of(values_at(r, t), inverse, n) : 0.0f;
}

float mass_in_front(Recurrence r, int n, float z, float overestimation) {
  vec4 inverse = inverse_norms(r, n), at_z = values_at(r, z);
  vec4 roots = real_roots(in_powers(r, n, at_z * inverse), n);
  float mass = overestimation / kernel_of(at_z, inverse, n);
  mass += mass_before(r, inverse, n, roots.x, z) + mass_before(r, inverse, n, roots.y, z);
  if (n >= 3) mass += mass_before(r, inverse, n, roots.z, z);
  if (n >= 4) mass += mass_before(r, inverse, n, roots.w, z);
  return mass;
}
