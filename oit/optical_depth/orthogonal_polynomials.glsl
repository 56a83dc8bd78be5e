// SPDX-License-Identifier: GPL-3.0-or-later
// The polynomials that are orthogonal to a distribution of which moments are known, for GLSL and,
// through GLM, for C++. Degrees are 4 at most. There are no loops: every index is a constant, so that
// arrays live in registers, and where the degree is a constant the branches are gone, too.
#ifndef ORTHOGONAL_POLYNOMIALS
#define ORTHOGONAL_POLYNOMIALS

// p_k(t) = t^k - sum l_kj p_j(t) over j < k, with the squared norms d_k: the LDL factors of the
// Hankel matrix of the moments.
struct Polynomials {
  float d[5];
  vec4 l1, l2, l3, l4;  // l_kj = lk[j]
};

// Rounding may turn the smallest norms negative.
float held_norm(float d) { return max(d, 1e-10f); }

// `m`: moments 0 to 2 n of the distribution.
Polynomials orthogonal_polynomials(float m[9], int n) {
  Polynomials p;
  p.d[0] = held_norm(m[0]);
  p.l1[0] = m[1] / p.d[0];
  p.d[1] = held_norm(m[2] - p.l1[0] * p.l1[0] * p.d[0]);
  p.l2[0] = m[2] / p.d[0];
  p.l2[1] = (m[3] - p.l2[0] * p.l1[0] * p.d[0]) / p.d[1];
  p.d[2] = held_norm(m[4] - p.l2[0] * p.l2[0] * p.d[0] - p.l2[1] * p.l2[1] * p.d[1]);
  if (n < 3) return p;
  p.l3[0] = m[3] / p.d[0];
  p.l3[1] = (m[4] - p.l3[0] * p.l1[0] * p.d[0]) / p.d[1];
  p.l3[2] = (m[5] - p.l3[0] * p.l2[0] * p.d[0] - p.l3[1] * p.l2[1] * p.d[1]) / p.d[2];
  p.d[3] = held_norm(m[6] - p.l3[0] * p.l3[0] * p.d[0] - p.l3[1] * p.l3[1] * p.d[1] -
             p.l3[2] * p.l3[2] * p.d[2]);
  if (n < 4) return p;
  p.l4[0] = m[4] / p.d[0];
  p.l4[1] = (m[5] - p.l4[0] * p.l1[0] * p.d[0]) / p.d[1];
  p.l4[2] = (m[6] - p.l4[0] * p.l2[0] * p.d[0] - p.l4[1] * p.l2[1] * p.d[1]) / p.d[2];
  p.l4[3] = (m[7] - p.l4[0] * p.l3[0] * p.d[0] - p.l4[1] * p.l3[1] * p.d[1] -
             p.l4[2] * p.l3[2] * p.d[2]) / p.d[3];
  p.d[4] = held_norm(m[8] - p.l4[0] * p.l4[0] * p.d[0] - p.l4[1] * p.l4[1] * p.d[1] -
             p.l4[2] * p.l4[2] * p.d[2] - p.l4[3] * p.l4[3] * p.d[3]);
  return p;
}

// Values p_0(t) … p_n(t), or coefficients of 1, t, …, t^n.
struct Vector5 {
  float v[5];
};

Vector5 values_at(Polynomials p, float t) {
  Vector5 q;
  float t2 = t * t;
  q.v[0] = 1.0f;
  q.v[1] = t - p.l1[0];
  q.v[2] = t2 - p.l2[0] - p.l2[1] * q.v[1];
  q.v[3] = t2 * t - p.l3[0] - p.l3[1] * q.v[1] - p.l3[2] * q.v[2];
  q.v[4] = t2 * t2 - p.l4[0] - p.l4[1] * q.v[1] - p.l4[2] * q.v[2] - p.l4[3] * q.v[3];
  return q;
}

// K(t, t) = sum p_k(t)^2 / d_k over k <= n.
float kernel(Polynomials p, int n, float t) {
  Vector5 q = values_at(p, t);
  float sum = q.v[0] / p.d[0] + q.v[1] * q.v[1] / p.d[1];
  if (n >= 2) sum += q.v[2] * q.v[2] / p.d[2];
  if (n >= 3) sum += q.v[3] * q.v[3] / p.d[3];
  if (n >= 4) sum += q.v[4] * q.v[4] / p.d[4];
  return sum;
}

// The coefficients of sum e_k p_k in powers of t.
Vector5 in_powers(Polynomials p, int n, Vector5 e) {
  if (n >= 4) {
    e.v[0] -= p.l4[0] * e.v[4];
    e.v[1] -= p.l4[1] * e.v[4];
    e.v[2] -= p.l4[2] * e.v[4];
    e.v[3] -= p.l4[3] * e.v[4];
  }
  if (n >= 3) {
    e.v[0] -= p.l3[0] * e.v[3];
    e.v[1] -= p.l3[1] * e.v[3];
    e.v[2] -= p.l3[2] * e.v[3];
  }
  e.v[0] -= p.l2[0] * e.v[2];
  e.v[1] -= p.l2[1] * e.v[2];
  e.v[0] -= p.l1[0] * e.v[1];
  return e;
}
#endif
