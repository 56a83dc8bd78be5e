// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth in front of a depth from power moments, for GLSL and, through GLM, for C++:
// Muenstermann, Krumpen, Klein and Peters 2018.
//
// Of all distributions on the line with the given moments, the canonical one with mass at z holds
// most mass at z. Its other points are the roots in t of the kernel K(t, z) = sum p_k(t) p_k(z)/d_k
// of the orthogonal polynomials, and a point t has the mass 1 / K(t, t). What lies in front of z is
// the mass of the points before it, and of z itself the share `overestimation`.
#include "oit/optical_depth/real_roots.glsl"

float mass_before(Polynomials p, int n, float t, float z) {
  return t < z ? 1.0f / kernel(p, n, t) : 0.0f;
}

// `moments` 0 to 2 n of a distribution of mass 1 on [-1, 1], n = 2, 3, 4.
float mass_in_front(float moments[9], int n, float z, float overestimation) {
  Polynomials p = orthogonal_polynomials(moments, n);
  Vector5 e = values_at(p, z);
  e.v[0] /= p.d[0];
  e.v[1] /= p.d[1];
  e.v[2] /= p.d[2];
  e.v[3] = n < 3 ? 0.0f : e.v[3] / p.d[3];
  e.v[4] = n < 4 ? 0.0f : e.v[4] / p.d[4];
  vec4 roots = real_roots(in_powers(p, n, e), n);
  float mass = overestimation / kernel(p, n, z);
  mass += mass_before(p, n, roots.x, z) + mass_before(p, n, roots.y, z);
  if (n >= 3) mass += mass_before(p, n, roots.z, z);
  if (n >= 4) mass += mass_before(p, n, roots.w, z);
  return mass;
}
