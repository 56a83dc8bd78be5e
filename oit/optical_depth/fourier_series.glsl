// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FOURIER_SERIES
#define FOURIER_SERIES
// A Fourier series of Dirac impulses and its integral, for GLSL and, through GLM, for C++.
// Equation numbers: Baeza Rojo et al. 2019. A band's coefficients are the pair (a_k, b_k), k = 0
// included; a wave is (cos, sin) of 2 pi k d.

const float PI = 3.14159265358979324f;

// (cos, sin) of 2 pi d, d in [0, 1], within 5e-7: the power series at half the angle from the
// middle, then doubled. cos() and sin() would first reduce the angle, which takes as long again.
vec2 first_wave(float d) {
  float y = PI * (d - 0.5f), z = y * y;
  float s = 1.0f - z * (1.0f / 156.0f);
  s = 1.0f - z * (1.0f / 110.0f) * s;
  s = 1.0f - z * (1.0f / 72.0f) * s;
  s = 1.0f - z * (1.0f / 42.0f) * s;
  s = 1.0f - z * (1.0f / 20.0f) * s;
  s = y * (1.0f - z * (1.0f / 6.0f) * s);
  float c = 1.0f - z * (1.0f / 132.0f);
  c = 1.0f - z * (1.0f / 90.0f) * c;
  c = 1.0f - z * (1.0f / 56.0f) * c;
  c = 1.0f - z * (1.0f / 30.0f) * c;
  c = 1.0f - z * (1.0f / 12.0f) * c;
  c = 1.0f - z * 0.5f * c;
  return vec2(2.0f * s * s - 1.0f, -2.0f * s * c);
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
