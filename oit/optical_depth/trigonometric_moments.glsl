// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth in front of a depth from trigonometric moments, for GLSL and, through GLM, for C++:
// Muenstermann, Krumpen, Klein and Peters 2018.
//
// Depth d in [0, 1] goes to the angle phi = range d of a circle, range < 2 pi; the moments are sums of
// tau cos k phi and tau sin k phi. Seen from the angle of z, psi = phi - phi_z, the line
// x = cot(psi / 2) is the circle without that point: x falls from infinity at psi = 0 to -infinity at
// psi = 2 pi. With sin^2 n(psi / 2) as weight the moments on the line
//
//   h_j = integral of x^j sin^2n(psi / 2) = integral of cos^j(psi / 2) sin^(2n-j)(psi / 2)
//
// are sums of the first n trigonometric moments, j = 0 … 2 n. The canonical distribution with mass
// at z is that with mass at infinity: the Gauss points, roots of the orthogonal polynomial p_n, and
// at infinity what h_2n has beyond theirs, which is d_n.
#include "oit/optical_depth/real_roots.glsl"

// Sums of tau cos k phi and tau sin k phi, k = 0 … n.
struct TrigonometricMoments {
  vec2 b[5];
};

vec2 product(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

// As seen from the angle whose cosine and sine are `point`.
TrigonometricMoments seen_from(TrigonometricMoments m, vec2 point) {
  vec2 turn = vec2(point.x, -point.y), turn2 = product(turn, turn);
  m.b[1] = product(m.b[1], turn);
  m.b[2] = product(m.b[2], turn2);
  m.b[3] = product(m.b[3], product(turn, turn2));
  m.b[4] = product(m.b[4], product(turn2, turn2));
  return m;
}

// h_0 … h_n.
struct HalfAngleMoments {
  float h[5];
};

HalfAngleMoments half_angle_moments(TrigonometricMoments m, int n) {
  float c0 = m.b[0].x, c1 = m.b[1].x, c2 = m.b[2].x, c3 = m.b[3].x, c4 = m.b[4].x;
  float s1 = m.b[1].y, s2 = m.b[2].y, s3 = m.b[3].y, s4 = m.b[4].y;
  HalfAngleMoments a;
  if (n == 2) {
    a.h[0] = (3.0f * c0 - 4.0f * c1 + c2) / 8.0f;
    a.h[1] = (2.0f * s1 - s2) / 8.0f;
    a.h[2] = (c0 - c2) / 8.0f;
  } else if (n == 3) {
    a.h[0] = (10.0f * c0 - 15.0f * c1 + 6.0f * c2 - c3) / 32.0f;
    a.h[1] = (5.0f * s1 - 4.0f * s2 + s3) / 32.0f;
    a.h[2] = (2.0f * c0 - c1 - 2.0f * c2 + c3) / 32.0f;
    a.h[3] = (3.0f * s1 - s3) / 32.0f;
  } else {
    a.h[0] = (35.0f * c0 - 56.0f * c1 + 28.0f * c2 - 8.0f * c3 + c4) / 128.0f;
    a.h[1] = (14.0f * s1 - 14.0f * s2 + 6.0f * s3 - s4) / 128.0f;
    a.h[2] = (5.0f * c0 - 4.0f * c1 - 4.0f * c2 + 4.0f * c3 - c4) / 128.0f;
    a.h[3] = (6.0f * s1 - 2.0f * s2 - 2.0f * s3 + s4) / 128.0f;
    a.h[4] = (3.0f * c0 - 4.0f * c2 + c4) / 128.0f;
  }
  return a;
}

// As h_j, but of sin^j cos^(2n-j), which is h_(2n-j): with pi - psi in place of psi.
HalfAngleMoments mirrored_half_angle_moments(TrigonometricMoments m, int n) {
  m.b[1].x = -m.b[1].x;
  m.b[2].y = -m.b[2].y;
  m.b[3].x = -m.b[3].x;
  m.b[4].y = -m.b[4].y;
  return half_angle_moments(m, n);
}

// Of a point at phi_z + psi: 1 past a full turn, where it is before z, otherwise 0. Between the range's end and a full turn it could be either
// behind all depths or in front of them: the share grows from 0 to 1.
float share_in_front(float angle, float range) {
  const float turn = 6.28318530717958648f;
  return angle >= turn ? 1.0f : clamp((angle - range) / (turn - range), 0.0f, 1.0f);
}

Polynomials polynomials_seen_from(TrigonometricMoments m, int n, vec2 point) {
  m = seen_from(m, point);
  HalfAngleMoments a = half_angle_moments(m, n), b = mirrored_half_angle_moments(m, n);
  float h[9];
  h[0] = a.h[0];
  h[1] = a.h[1];
  h[2] = a.h[2];
  h[3] = n == 2 ? b.h[1] : a.h[3];
  h[4] = n == 2 ? b.h[0] : n == 3 ? b.h[2] : a.h[4];
  h[5] = n == 3 ? b.h[1] : b.h[3];
  h[6] = n == 3 ? b.h[0] : b.h[2];
  h[7] = b.h[1];
  h[8] = b.h[0];
  return orthogonal_polynomials(h, n);
}

// Of the Gauss point x: what of its mass is in front of z.
float gauss_mass(Polynomials p, int n, float x, float phi, float range) {
  float w = 1.0f + x * x, weight = n == 2 ? w * w : n == 3 ? w * w * w : w * w * w * w;
  return share_in_front(phi + 2.0f * atan(1.0f, x), range) * weight / kernel(p, n - 1, x);
}

// m: of a distribution of mass 1.
float mass_in_front_of_angle(TrigonometricMoments m, int n, float phi, float range,
                             float overestimation) {
  Polynomials p = polynomials_seen_from(m, n, vec2(cos(phi), sin(phi)));
  Vector5 last;
  last.v[0] = last.v[1] = 0.0f;
  last.v[2] = n == 2 ? 1.0f : 0.0f;
  last.v[3] = n == 3 ? 1.0f : 0.0f;
  last.v[4] = n == 4 ? 1.0f : 0.0f;
  vec4 x = real_roots(in_powers(p, n, last), n);
  float mass = overestimation * (n == 2 ? p.d[2] : n == 3 ? p.d[3] : p.d[4]);
  mass += gauss_mass(p, n, x.x, phi, range) + gauss_mass(p, n, x.y, phi, range);
  if (n >= 3) mass += gauss_mass(p, n, x.z, phi, range);
  if (n >= 4) mass += gauss_mass(p, n, x.w, phi, range);
  return mass;
}
