// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FOURIER_SERIES
#define FOURIER_SERIES
// A Fourier series of Dirac impulses and its integral, for GLSL and, through GLM, for C++.
// Equation numbers: Baeza Rojo et al. 2019. A band's coefficients are the pair (a_k, b_k), k = 0
// included; a wave is (cos, sin) of 2 pi k d.

const float PI = 3.14159265358979324f;

// (cos, sin) of 2 pi d, d in [0, 1], within 5e-7: minimax polynomials of sin and cos of half the
// angle from the middle, within 5e-9 and 6e-8, then doubled. cos() and sin() would first reduce the
// angle, which takes as long again.
vec2 first_wave(float d) {
  float y = PI * (d - 0.5f), z = y * y;
  float s = -1.980661473e-4f + z * 2.600053222e-6f;
  s = y * (1.0f + z * (-0.1666665673f + z * (8.333017118e-3f + z * s)));
  float c = -1.385592623e-3f + z * 2.319436680e-5f;
  c = 1.0f + z * (-0.4999993145f + z * (4.166398942e-2f + z * c));
  return vec2(1.0f - 2.0f * c * c, -2.0f * s * c);
}

// exp(i (x + y)) from exp(i x) and exp(i y): the other waves from the first one.
vec2 add_angles(vec2 x, vec2 y) {
  return vec2(x.x * y.x - x.y * y.y, x.y * y.x + x.x * y.y);
}

// Eq. 8 (and 16, 17 with f = -ln(1 - alpha)): what an impulse f adds to a band's coefficients.
vec2 fourier_project(float f, vec2 wave) { return 2.0f * f * wave; }

// A band's term of Eq. 5, the integral from 0 to d.
float fourier_integral(int k, vec2 coefficients, float d, vec2 wave) {
  if (k == 0) return 0.5f * coefficients.x * d;
  return (coefficients.x * wave.y + coefficients.y * (1.0f - wave.x)) * (0.5f / PI / float(k));
}
#endif
